#include "ui/panels/viewport/tools/drag_tool.h"

#include <cmath>
#include <cstdio>

#include "ui/panels/text/number_text.h"

namespace hazumi::ui {

DragTool::DragTool(Editor* editor, const char* kind, bool is_held)
    : drag_(kind + std::to_string(++editor->viewport.drags)), is_held_(is_held) {
  editor->playback.Stop();
  editor->Do("edit.end_drag");
  editor->Say("");
}

bool DragTool::Update(Editor* editor, const ToolInput& input) {
  if (input.cancel || !Follow(editor, input)) {
    TakeBack(editor);
    return false;
  }
  if (!IsConfirmed(input)) return true;
  editor->Do("edit.end_drag");
  return false;
}

Result<Done> DragTool::Try(Editor* editor, const std::string& id, Json parameters) {
  parameters["drag"] = drag_;
  has_run_ = true;
  return editor->Invoke(id, parameters);
}

bool DragTool::Run(Editor* editor, const std::string& id, Json parameters) {
  return Try(editor, id, std::move(parameters)).ok();
}

void DragTool::TakeBack(Editor* editor) {
  if (has_run_) editor->Do("edit.cancel_drag");
  has_run_ = false;
}

Point DragTool::MouseMoved(const ToolInput& input) {
  const Point from = last_mouse_.value_or(input.mouse);
  last_mouse_ = input.mouse;
  const float share = input.precise ? 0.1f : 1.0f;
  return {share * (input.mouse.x - from.x), share * (input.mouse.y - from.y)};
}

bool TypedAxis::Take(const Chord& chord) {
  if (chord.key < 'X' || chord.key > 'Z' || chord.ctrl || chord.alt) return false;
  const bool is_again = chord.key == letter_;
  letter_ = is_again && is_own_ ? 0 : static_cast<char>(chord.key);
  is_own_ = is_again && !is_own_;
  return true;
}

std::string TypedAxis::shown() const {
  if (is_none()) return "";
  return std::string("  ") + Tr(is_own_ ? "own" : "world") + " " + letter_;
}

double ToCentimetres(double metres) {
  return std::round(100.0 * metres) / 100.0 + 0.0;  // adding 0 leaves no -0
}

std::string Signed(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%+.*f", digits, WithoutMinusZero(value, digits));
  return text;
}

std::string KeysHint(const char* axis) {
  return std::string("   Enter: ") + Tr("confirm") + "   Esc: " + Tr("cancel") +
         "   X Y Z: " + axis + "   0-9: " + Tr("number") + "   Shift: " + Tr("precise") +
         "   Ctrl: " + Tr("snap");
}

}  // namespace hazumi::ui
