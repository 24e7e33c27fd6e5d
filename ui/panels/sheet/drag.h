#pragma once

#include <string>

#include "ui/panels/sheet/time_axis.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A tool of the dope sheet or the graph editor that follows the mouse, one undo step at most. Held
// by the left button it is confirmed when that is let go, else by a click or Enter.
class SheetDrag : public Tool {
 public:
  bool Update(Editor* editor, const ToolInput& input) final;

 protected:
  // Ends whatever drag was on before.
  SheetDrag(Editor* editor, Point start, bool by_button);

  virtual void Follow(Editor* editor, const ToolInput& input) = 0;
  // What the document became stays, as one undo step.
  virtual void Finish(Editor* editor) { editor->Do("edit.end_drag"); }
  // Everything is as it was.
  virtual void Cancel(Editor* editor) { editor->Do("edit.cancel_drag"); }

  Point start() const { return start_; }
  // The mouse has left the place where it began; a tool that is not held moves at once.
  bool has_moved() const { return has_moved_; }
  // For the parameter "drag" of operators, another text each time.
  const std::string& drag() const { return drag_; }

 private:
  Point start_;
  bool by_button_;
  bool has_moved_;
  std::string drag_;
};

// Time as the sheet shows it at the moment.
TimeAxis SheetAxis(const Editor& editor);

// What the keys do in every such tool, for the status bar.
std::string DragKeys(bool takes_numbers);
// "5 - 15"
std::string SpanText(int first, int last);
// A number as a hint shows it, with its sign.
std::string Signed(double value);

}  // namespace hazumi::ui
