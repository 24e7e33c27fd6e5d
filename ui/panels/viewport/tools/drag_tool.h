#pragma once

#include <string>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A tool of the viewport whose edits are one undo step, or none if it is cancelled.
class DragTool : public Tool {
 public:
  bool Update(Editor* editor, const ToolInput& input) final;

 protected:
  // `is_held`: confirmed when the left button comes up.
  DragTool(Editor* editor, const char* kind, bool is_held);

  // The input is the last one: by default a click, or the button that comes up.
  virtual bool IsConfirmed(const ToolInput& input) const {
    return is_held_ ? !input.is_held : input.confirm;
  }

  // Acts on the input. False: it cannot go on, and what it did is taken back.
  virtual bool Follow(Editor* editor, const ToolInput& input) = 0;

  // Runs an operator that takes `drag`.
  Result<Done> Try(Editor* editor, const std::string& id, Json parameters);
  bool Run(Editor* editor, const std::string& id, Json parameters);
  // As if nothing had been run.
  void TakeBack(Editor* editor);
  // What the mouse moved since the last call, a tenth of it with Shift [px].
  Point MouseMoved(const ToolInput& input);
  void BeginAt(Point mouse) { last_mouse_ = mouse; }

 private:
  std::string drag_;
  bool is_held_, has_run_ = false;
  std::optional<Point> last_mouse_;
};

// An axis that is chosen by its letter: typed once it is the world's, twice that of what is turned,
// a third time there is none.
class TypedAxis {
 public:
  // True if it was one of the letters.
  bool Take(const Chord& chord);
  int index() const { return letter_ - 'X'; }  // of x, y, z, if there is one
  bool is_none() const { return letter_ == 0; }
  bool is_own() const { return is_own_; }
  // "  world X"; empty if there is none.
  std::string shown() const;

 private:
  char letter_ = 0;
  bool is_own_ = false;
};

// Places under the mouse are given no finer.
double ToCentimetres(double metres);
// "+12.5"; with so many digits after the point.
std::string Signed(double value, int digits);
// The keys that tools understand, for their hints; those that matter most go first, for the last
// ones are left out where there is no room.
std::string KeysHint(const char* axis);

}  // namespace hazumi::ui
