// The handle at an elbow or a knee: turns the limb about its own axis, hand or foot staying.

#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/panels/viewport/dial.h"
#include "ui/panels/viewport/swivel_handle.h"
#include "ui/panels/viewport/tools/drag_tool.h"

namespace hazumi::ui {

namespace {

class SwivelTool : public DragTool {
 public:
  SwivelTool(Editor* editor, const SwivelHandle& handle, const View& view, HeldFrom held)
      : DragTool(editor, "viewport.swivel ", true),
        joint_(handle.joint),
        turns_away_(handle.axis.dot(view.ToViewer(handle.center)) < 0.0),
        dial_(view, handle.center, handle.axis, handle.at) {
    BeginAt(held.mouse);
    dial_.BeginAt(held.mouse);
  }

  std::string hint() const override {
    return std::string(Tr("Swivel limb")) + " " + joint_ + ": " +
           (typed_.is_empty() ? Signed(by_deg_, 1) : typed_.shown()) +
           "\u00b0   Enter: " + Tr("confirm") + "   Esc: " + Tr("cancel") +
           "   0-9: " + Tr("number") + "   Shift: " + Tr("precise") + "   Ctrl: " + Tr("snap");
  }

 private:
  // Each time from the beginning.
  bool Follow(Editor* editor, const ToolInput& input) override {
    for (const Chord& chord : input.keys) typed_.Take(chord);
    dial_.Move(MouseMoved(input));
    const double by_mouse = input.snap ? dial_.snapped_degrees() : dial_.degrees();
    const bool is_other_way = turns_away_ && !dial_.is_tangential();
    const double by = typed_.is_empty() ? (is_other_way ? -by_mouse : by_mouse) : typed_.value();
    if (by == by_deg_) return true;
    by_deg_ = by;
    TakeBack(editor);
    // Where a limit is in the way the limb waits for the mouse to come back.
    Run(editor, "pose.swivel", {{"joint", joint_}, {"angle", by}});
    return true;
  }

  std::string joint_;
  bool turns_away_;  // its axis points away from the viewer
  Dial dial_;
  double by_deg_ = 0.0;
  TypedNumber typed_;
};

}  // namespace

std::optional<SwivelHandle> SwivelHandleOf(const edit::Session& session,
                                           const PosedFigure& figure) {
  constexpr double kBent = 0.01;  // so far off the line the handle must be to go round it [m]
  const std::vector<GroupIndex> joints = SelectedJoints(session);
  if (joints.size() != 1) return std::nullopt;
  const auto chain = ChainOf(joints[0], std::nullopt, figure.figure());
  if (!edit::EndsLimb(joints[0], figure.figure()) || chain.size() != 2) return std::nullopt;
  SwivelHandle handle;
  handle.joint = figure.figure().group(joints[0]).name;
  handle.at = figure.CenterOf(chain.front());
  const Vec3 from = figure.CenterOf(chain.back()), line = figure.CenterOf(joints[0]) - from;
  if (line.norm() < kBent) return std::nullopt;
  handle.axis = line.normalized();
  handle.center = from + (handle.at - from).dot(handle.axis) * handle.axis;
  if ((handle.at - handle.center).norm() < kBent) return std::nullopt;
  return handle;
}

void TakeSwivelTool(Editor* editor, const SwivelHandle& handle, HeldFrom held) {
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  editor->Take(std::make_unique<SwivelTool>(editor, handle, view, held));
}

}  // namespace hazumi::ui
