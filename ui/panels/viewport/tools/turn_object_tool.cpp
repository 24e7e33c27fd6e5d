// R on a held object: turns it in the hand that holds it.

#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/dial.h"
#include "ui/panels/viewport/solids.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

class TurnObjectTool : public DragTool {
 public:
  TurnObjectTool(Editor* editor, std::string name, const hazumi::Pose& X_WO, const View& view)
      : DragTool(editor, "viewport.turn_object ", false),
        name_(std::move(name)),
        R_WO_(X_WO.R),
        to_viewer_(view.ToViewer(X_WO.p)),
        dial_(view.ToWindow(X_WO.p).value_or(Point{})) {}

  std::string hint() const override {
    const std::string degrees = typed_.is_empty() ? Signed(by_deg_, 1) : typed_.shown();
    return std::string(Tr("Rotate")) + " " + name_ + letter_.shown() + ": " + degrees + "\u00b0" +
           KeysHint(Tr("axis, twice: its own"));
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  Vec3 Axis() const {
    if (letter_.is_none()) return to_viewer_;
    return letter_.is_own() ? Vec3(R_WO_.col(letter_.index())) : Vec3::Unit(letter_.index());
  }

  std::string name_;
  Mat3 R_WO_;  // where it began
  Vec3 to_viewer_;
  TypedAxis letter_;
  Dial dial_;
  TypedNumber typed_;
  double by_deg_ = 0.0;
  Vec3 turned_ = Vec3::Zero();  // what the operator was asked for last [deg]
};

// The mouse turns what is seen, a number is about the axis. Each time from the beginning.
bool TurnObjectTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) {
    if (!typed_.Take(chord)) letter_.Take(chord);
  }
  if (!dial_.has_begun()) dial_.BeginAt(input.mouse);
  dial_.Move(MouseMoved(input));
  const Vec3 axis = Axis();
  const double by_mouse = input.snap ? dial_.snapped_degrees() : dial_.degrees();
  by_deg_ = !typed_.is_empty() ? typed_.value() : axis.dot(to_viewer_) < 0.0 ? -by_mouse : by_mouse;
  const Vec3 turn = by_deg_ * axis;
  if (turn == turned_) return true;
  turned_ = turn;
  TakeBack(editor);
  return Run(editor, "held.turn",
             {{"object", name_}, {"x", turn.x()}, {"y", turn.y()}, {"z", turn.z()}});
}

}  // namespace

Result<Done> TakeTurnObjectTool(Editor* editor) {
  const auto figure = PoseNow(&editor->session());
  const ProjectHeldObject* held = SelectedHeldObject(*editor);
  if (!figure || !held) {
    return Error{ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
  }
  const int index = hazumi::IndexOf(held->identity.id, editor->session().project().held_objects);
  const std::vector<ObjectPose>& poses = figure->frame().objects;
  if (static_cast<size_t>(index) >= poses.size()) {
    return Error{ErrorCode::kSemantics, "", "", "the motion is still being computed: try again"};
  }
  if (!poses[index].is_held()) {
    return Error{ErrorCode::kSchema, "", "",
                 "nobody has it in this frame: it is turned in a hand; go to a frame in which one "
                 "has it"};
  }
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  editor->Take(nullptr);
  editor->Take(std::make_unique<TurnObjectTool>(editor, held->name, poses[index].X_WO, view));
  return Done();
}

}  // namespace hazumi::ui
