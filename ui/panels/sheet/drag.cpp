#include "ui/panels/sheet/drag.h"

#include <cmath>

#include "engine/base/text.h"
#include "ui/panels/sheet/frame.h"

namespace hazumi::ui {

SheetDrag::SheetDrag(Editor* editor, Point start, bool by_button)
    : start_(start),
      by_button_(by_button),
      has_moved_(!by_button),
      drag_("sheet " + std::to_string(++editor->sheet.num_drags)) {
  editor->Do("edit.end_drag");
}

bool SheetDrag::Update(Editor* editor, const ToolInput& input) {
  const double away = std::hypot(input.mouse.x - start_.x, input.mouse.y - start_.y);
  constexpr double kStill = 3.0;  // [px] at scale 1
  has_moved_ = has_moved_ || away > kStill * editor->settings.scale;
  if (input.cancel) {
    Cancel(editor);
  } else {
    Follow(editor, input);
    const bool is_done = by_button_ ? !input.is_held : input.confirm;
    if (!is_done) return true;
    Finish(editor);
  }
  editor->sheet.is_quiet = true;
  return false;
}

TimeAxis SheetAxis(const Editor& editor) {
  return LayOutSheetFrame(editor.session(), editor.sheet, editor.sheet.rect, editor.settings.scale)
      .axis;
}

std::string DragKeys(bool takes_numbers) {
  const std::string keys = Tr("Enter: confirm   Esc: cancel");
  return takes_numbers ? keys + "   " + Tr("or type a number") : keys;
}

std::string SpanText(int first, int last) {
  return std::to_string(first) + " - " + std::to_string(last);
}

std::string Signed(double value) { return (value > 0.0 ? "+" : "") + FormatShort(value); }

}  // namespace hazumi::ui
