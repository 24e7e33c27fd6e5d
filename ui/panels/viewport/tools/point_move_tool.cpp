#include "ui/panels/viewport/tools/point_move_tool.h"

namespace hazumi::ui {

namespace {

constexpr double kSnapMeters = 0.05;  // with Ctrl [m]

// How far along an axis through `p` the line through the mouse passes it [m].
double AlongAxis(const View& view, Point at, const Vec3& p, const Vec3& axis) {
  const Ray ray = view.Through(at);
  const double c = axis.dot(ray.direction), denominator = 1.0 - c * c;
  if (!(denominator >= 1e-4)) return 0.0;
  const Vec3 w = p - ray.from;
  return (c * w.dot(ray.direction) - w.dot(axis)) / denominator;
}

}  // namespace

PointMoveTool::PointMoveTool(Editor* editor, std::string name, const Vec3& from,
                             std::optional<HeldFrom> held)
    : DragTool(editor, "viewport.move ", held.has_value()), name_(std::move(name)), from_(from) {
  if (!held) return;
  BeginAt(held->mouse);
  start_ = mouse_ = held->mouse;
}

std::string PointMoveTool::hint() const {
  std::string text = std::string(Tr("Move")) + " " + moved() + ": ";
  if (!typed_.is_empty()) {
    text += std::string(1, axis_ ? axis_ : 'X') + " " + typed_.shown() + " m";
  } else {
    for (int i = 0; i < 3; ++i) {
      text += std::string(i ? "  " : "") + "XYZ"[i] + " " + Signed(offset_[i], 3);
    }
    text += " m";
  }
  return text + MoreHint() + KeysHint(Tr("axis"));
}

Vec3 PointMoveTool::OffsetOf(const View& view, bool snap) const {
  Vec3 offset = Vec3::Zero();
  const Vec3 axis = Vec3::Unit((axis_ ? axis_ : 'X') - 'X');
  if (!typed_.is_empty()) return typed_.value() * axis;
  // Where it began it is as it was, whatever is seen there, and if nothing is.
  if (mouse_.x == start_->x && mouse_.y == start_->y) return offset;
  if (axis_) {
    offset = (AlongAxis(view, mouse_, from_, axis) - AlongAxis(view, *start_, from_, axis)) * axis;
  } else {
    const auto to = view.OnPlane(mouse_, from_, PlaneOf(view));
    const auto from = view.OnPlane(*start_, from_, PlaneOf(view));
    if (to && from) offset = *to - *from;
  }
  if (!snap) return offset;
  return (offset / kSnapMeters).array().round().matrix() * kSnapMeters;
}

bool PointMoveTool::Follow(Editor* editor, const ToolInput& input) {
  bool has_changed = false;
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord)) continue;
    if (chord.key >= 'X' && chord.key <= 'Z') axis_ = static_cast<char>(chord.key);
    has_changed |= TakeKey(chord);
  }
  if (!start_) start_ = mouse_ = input.mouse;
  const Point by = MouseMoved(input);
  mouse_ = {mouse_.x + by.x, mouse_.y + by.y};
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const Vec3 offset = OffsetOf(view, input.snap);
  if (offset == offset_ && !has_changed) return true;
  offset_ = offset;
  return Place(editor, offset);
}

}  // namespace hazumi::ui
