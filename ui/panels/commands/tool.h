#pragma once

#include <string>
#include <vector>

#include "ui/panels/commands/keys.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

class Editor;

// What happened since the last frame while a tool was in hand. It is all that a tool knows of mouse
// and keys: who feeds it need not be a window.
struct ToolInput {
  Point mouse;              // where the mouse is now
  std::vector<Chord> keys;  // pressed, in order
  bool confirm = false;     // left button or Enter
  bool cancel = false;      // right button or Esc
  bool is_pressed = false;  // the left button went down
  bool is_held = false;     // the left button is down
  bool precise = false;     // Shift is held
  bool snap = false;        // Ctrl is held
};

// A tool that has the mouse and the keys until it is confirmed or cancelled, such as G, R and S.
class Tool {
 public:
  virtual ~Tool() = default;
  // What it is doing and what the keys do now, for the status bar.
  virtual std::string hint() const = 0;
  // The mouse points at the scene: nothing else may lie on it.
  virtual bool aims() const { return false; }
  // Follows the mouse; true as long as the tool stays in hand. On cancel it leaves the document as
  // it was when it was taken.
  virtual bool Update(Editor* editor, const ToolInput& input) = 0;
};

// A number that is typed into a tool: digits, a point and a sign; "-" changes the sign wherever it
// is typed.
class TypedNumber {
 public:
  // True if the key belongs to the number.
  bool Take(const Chord& chord);
  bool is_empty() const { return text_.empty(); }
  double value() const;
  // As it was typed, with a cursor.
  std::string shown() const;

 private:
  std::string text_;
  bool is_negative_ = false;
};

}  // namespace hazumi::ui
