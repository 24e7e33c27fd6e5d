// R and the rings: turns hinges by the mouse or by typed degrees.

#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/dial.h"
#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

// The hinge whose axis is nearest to a direction, either way round.
template <typename AxisOf>
JointIndex Nearest(const std::vector<JointIndex>& hinges, const Vec3& direction, AxisOf axis_of) {
  return *std::max_element(hinges.begin(), hinges.end(), [&](JointIndex a, JointIndex b) {
    return std::abs(axis_of(a).dot(direction)) < std::abs(axis_of(b).dot(direction));
  });
}

class RotateTool : public DragTool {
 public:
  RotateTool(Editor* editor, std::vector<GroupIndex> joints)
      : DragTool(editor, "viewport.rotate ", false),
        joints_(std::move(joints)),
        active_(editor->viewport.active_hinge) {
    ChooseHinges(editor);
  }
  RotateTool(Editor* editor, const GizmoHit& ring, HeldFrom held)
      : DragTool(editor, "viewport.ring ", true), only_(ring.hinge), ring_at_(ring.at) {
    joints_ = {editor->session().figure().joint(ring.hinge).group};
    ChooseHinges(editor);
    BeginAt(held.mouse);
    dial_.BeginAt(held.mouse);
  }
  // All of them, by a ring about an axis of the world.
  RotateTool(Editor* editor, std::vector<GroupIndex> joints, const GizmoHit& ring, HeldFrom held)
      : DragTool(editor, "viewport.ring ", true),
        joints_(std::move(joints)),
        world_axis_(Vec3::Unit(ring.axis)),
        ring_at_(ring.at) {
    ChooseHinges(editor);
    BeginAt(held.mouse);
    dial_.BeginAt(held.mouse);
  }

  std::string hint() const override;

 private:
  // A hinge that is turned.
  struct Turn {
    std::string name;
    double start_deg, now_deg, lower_deg, upper_deg;
    double sign;     // 1: it turns as the dial does
    bool in_region;  // it swings in this frame: a key does not show
  };

  bool Follow(Editor* editor, const ToolInput& input) override;
  void ChooseHinges(Editor* editor);
  JointIndex HingeOf(const std::vector<JointIndex>& hinges, const PosedFigure& figure) const;
  Dial DialOf(const View& view, const PosedFigure& figure) const;
  double SignOf(JointIndex hinge, const PosedFigure& figure, const View& view) const;
  bool TakeChoice(const Chord& chord);
  void AddTurn(Editor* editor, JointIndex hinge, const PosedFigure& figure, const View& view);
  bool Apply(Editor* editor, double by_deg);

  std::vector<GroupIndex> joints_;
  std::optional<JointIndex> only_;  // whose ring was taken
  std::optional<Vec3> world_axis_;  // whose ring was taken, of all joints
  Vec3 ring_at_ = Vec3::Zero();     // where the ring was taken [m]
  std::string active_;              // the hinge whose limits were shown
  size_t num_next_ = 0;             // how often the next hinge was asked for
  bool has_choice_ = false;         // a joint has more than one hinge
  TypedAxis axis_;
  std::vector<Turn> turns_;
  Dial dial_{Point{}};
  double applied_deg_ = 0.0;
  TypedNumber typed_;
};

// The session stands as it was when the tool was taken.
void RotateTool::ChooseHinges(Editor* editor) {
  turns_.clear();
  has_choice_ = false;
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  Dial dial = DialOf(view, *figure);
  dial.GoOnFrom(dial_);
  dial_ = dial;
  for (const GroupIndex joint : joints_) {
    const std::vector<JointIndex> hinges = TurnableHinges(editor->session(), joint);
    if (hinges.empty()) continue;
    has_choice_ |= hinges.size() > 1;
    AddTurn(editor, HingeOf(hinges, *figure), *figure, view);
  }
}

// A ring seen from its edge is pulled along, not turned around its centre.
Dial RotateTool::DialOf(const View& view, const PosedFigure& figure) const {
  if (only_) return Dial(view, figure.PoseOf(*only_).p, figure.AxisOf(*only_), ring_at_);
  const Vec3 middle = figure.MiddleOf(joints_);
  if (world_axis_) return Dial(view, middle, *world_axis_, ring_at_);
  return Dial(view.ToWindow(middle).value_or(Point{}));
}

// Pulled along, a ring turns about its axis, else counter-clockwise on the screen. By a ring of the
// world all hinges turn the same way about its axis, wherever theirs point.
double RotateTool::SignOf(JointIndex hinge, const PosedFigure& figure, const View& view) const {
  const Vec3 axis = figure.AxisOf(hinge);
  const double along = world_axis_ && axis.dot(*world_axis_) < 0.0 ? -1.0 : 1.0;
  if (dial_.is_tangential()) return along;
  const Vec3 center = world_axis_ ? figure.MiddleOf(joints_) : figure.PoseOf(hinge).p;
  const double facing = world_axis_.value_or(axis).dot(view.ToViewer(center));
  return facing < 0.0 ? -along : along;
}

// The one whose limits are shown, else the first; then the others in turn. Or by an axis.
JointIndex RotateTool::HingeOf(const std::vector<JointIndex>& hinges,
                               const PosedFigure& figure) const {
  if (only_) return *only_;
  if (axis_.is_none() && !world_axis_) {
    size_t first = 0;
    for (size_t i = 0; i < hinges.size(); ++i) {
      if (figure.figure().joint(hinges[i]).name == active_) first = i;
    }
    return hinges[(first + num_next_) % hinges.size()];
  }
  const Vec3 direction = world_axis_ ? *world_axis_ : Vec3(Vec3::Unit(axis_.index()));
  return Nearest(hinges, direction, [&](JointIndex hinge) -> Vec3 {
    const Joint& joint = figure.figure().joint(hinge);
    return axis_.is_own() ? Vec3(joint.X_PJ.R * joint.axis) : figure.AxisOf(hinge);
  });
}

void RotateTool::AddTurn(Editor* editor, JointIndex hinge, const PosedFigure& figure,
                         const View& view) {
  const Joint& joint = figure.figure().joint(hinge);
  const double now = WithoutRoundOff(figure.frame().q[hinge.value()] / kDegree);
  turns_.push_back({joint.name, now, now, ShortestDegrees(joint.lower),
                    ShortestDegrees(joint.upper), SignOf(hinge, figure, view),
                    figure.frame().in_region[hinge.value()] != 0});
  if (turns_.size() == 1) editor->viewport.active_hinge = joint.name;
}

// Keys that choose another hinge.
bool RotateTool::TakeChoice(const Chord& chord) {
  if (only_ || world_axis_) return false;
  if (chord != Chord{'R'}) return axis_.Take(chord);
  if (axis_.is_none()) ++num_next_;
  axis_ = {};
  return true;
}

bool RotateTool::Follow(Editor* editor, const ToolInput& input) {
  if (turns_.empty()) return false;
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord) || !TakeChoice(chord)) continue;
    TakeBack(editor);
    applied_deg_ = 0.0;
    ChooseHinges(editor);
  }
  if (!dial_.has_begun()) dial_.BeginAt(input.mouse);
  dial_.Move(MouseMoved(input));
  const double by_mouse = input.snap ? dial_.snapped_degrees() : dial_.degrees();
  return Apply(editor, typed_.is_empty() ? by_mouse : typed_.value());
}

// Typed degrees are the hinge's own; the mouse turns what is seen.
bool RotateTool::Apply(Editor* editor, double by_deg) {
  if (by_deg == applied_deg_) return true;
  applied_deg_ = by_deg;
  for (Turn& turn : turns_) {
    const double signed_by = typed_.is_empty() ? turn.sign * by_deg : by_deg;
    const double to = turn.start_deg + signed_by;
    turn.now_deg = std::clamp(to, turn.lower_deg, turn.upper_deg);
    if (!Run(editor, "pose.rotate", {{"joint", turn.name}, {"to", to}})) return false;
  }
  return true;
}

std::string RotateTool::hint() const {
  if (turns_.empty()) return "";
  const Turn& turn = turns_[0];
  std::string text = std::string(Tr("Rotate")) + " " + turn.name;
  if (turns_.size() > 1) text += " +" + std::to_string(turns_.size() - 1);
  text += axis_.shown();
  text += ": " + (typed_.is_empty() ? Signed(turn.now_deg - turn.start_deg, 1) : typed_.shown());
  text += "\u00b0  =  " + Signed(turn.now_deg, 1) + "\u00b0";
  if (turn.now_deg == turn.lower_deg || turn.now_deg == turn.upper_deg) {
    text += std::string("  ") + Tr("at the limit");
  }
  if (turn.in_region) text += std::string("  ") + Tr("a region moves it in this frame");
  if (has_choice_ && !only_ && !world_axis_) text += std::string("   R: ") + Tr("next hinge");
  return text + KeysHint(Tr("axis, twice: its own"));
}

}  // namespace

Result<Done> TakeRotateTool(Editor* editor) {
  if (editor->session().is_root_selected() && PoseNow(&editor->session())) {
    editor->Take(nullptr);
    TakeRootTurnTool(editor);
    return Done();
  }
  std::vector<GroupIndex> joints = TurnableJoints(editor->session());
  if (joints.empty() && SelectedHeldObject(*editor)) return TakeTurnObjectTool(editor);
  if (joints.empty()) {
    return Error{ErrorCode::kSchema, "", "",
                 "no joint that turns and nothing in a hand is selected: click on one"};
  }
  if (!PoseNow(&editor->session())) {
    return Error{ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
  }
  editor->Take(nullptr);
  editor->Take(std::make_unique<RotateTool>(editor, std::move(joints)));
  return Done();
}

void TakeRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held) {
  if (ring.hinge.is_valid()) return editor->Take(std::make_unique<RotateTool>(editor, ring, held));
  editor->Take(std::make_unique<RotateTool>(editor, TurnableJoints(editor->session()), ring, held));
}

}  // namespace hazumi::ui
