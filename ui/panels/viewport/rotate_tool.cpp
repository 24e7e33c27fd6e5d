// R and the rings: turns hinges by the mouse or by typed degrees.

#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/viewport/dial.h"
#include "ui/panels/viewport/drag_tool.h"
#include "ui/panels/viewport/tools.h"

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
      : DragTool(editor, "viewport.rotate ", false), joints_(std::move(joints)) {
    ChooseHinges(editor);
  }
  RotateTool(Editor* editor, const GizmoHit& ring, HeldFrom held)
      : DragTool(editor, "viewport.ring ", true), only_(ring.hinge), ring_at_(ring.at) {
    joints_ = {editor->session().figure().joint(ring.hinge).group};
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
    double sign;     // 1: it turns counter-clockwise on the screen
    bool in_region;  // it swings in this frame: a key does not show
  };

  bool Follow(Editor* editor, const ToolInput& input) override;
  void ChooseHinges(Editor* editor);
  JointIndex HingeOf(const std::vector<JointIndex>& hinges, const Vec3& to_viewer,
                     const PosedFigure& figure) const;
  void AddTurn(Editor* editor, JointIndex hinge, const PosedFigure& figure, const View& view);
  bool Apply(Editor* editor, double by_deg);

  std::vector<GroupIndex> joints_;
  std::optional<JointIndex> only_;
  Vec3 ring_at_ = Vec3::Zero();  // where the ring was taken [m]
  TypedAxis axis_;
  std::vector<Turn> turns_;
  Dial dial_{Point{}};
  double applied_deg_ = 0.0;
  TypedNumber typed_;
};

// The session stands as it was when the tool was taken.
void RotateTool::ChooseHinges(Editor* editor) {
  turns_.clear();
  const auto figure = PoseNow(&editor->session());
  if (!figure) return;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  Vec3 pivot = Vec3::Zero();
  for (const GroupIndex joint : joints_) {
    const Vec3 center = figure->CenterOf(joint);
    pivot += center / static_cast<double>(joints_.size());
    const std::vector<JointIndex> hinges = TurnableHinges(editor->session(), joint);
    if (hinges.empty()) continue;
    AddTurn(editor, HingeOf(hinges, view.ToViewer(center), *figure), *figure, view);
  }
  // A ring seen from its edge is pulled along, not turned around its centre.
  Dial dial = only_ ? Dial(view, figure->PoseOf(*only_).p, figure->AxisOf(*only_), ring_at_)
                    : Dial(view.ToWindow(pivot).value_or(Point{}));
  if (dial.is_tangential() && !turns_.empty()) turns_[0].sign = 1.0;
  dial.GoOnFrom(dial_);
  dial_ = dial;
}

JointIndex RotateTool::HingeOf(const std::vector<JointIndex>& hinges, const Vec3& to_viewer,
                               const PosedFigure& figure) const {
  if (only_) return *only_;
  const Vec3 direction = axis_.is_none() ? to_viewer : Vec3(Vec3::Unit(axis_.index()));
  return Nearest(hinges, direction, [&](JointIndex hinge) -> Vec3 {
    const Joint& joint = figure.figure().joint(hinge);
    return axis_.is_own() ? Vec3(joint.X_PJ.R * joint.axis) : figure.AxisOf(hinge);
  });
}

void RotateTool::AddTurn(Editor* editor, JointIndex hinge, const PosedFigure& figure,
                         const View& view) {
  const Joint& joint = figure.figure().joint(hinge);
  const double now = edit::WithoutRoundOff(figure.frame().q[hinge.value()] / kDegree);
  const double facing = figure.AxisOf(hinge).dot(view.ToViewer(figure.PoseOf(hinge).p));
  turns_.push_back({joint.name, now, now, ShortestDegrees(joint.lower),
                    ShortestDegrees(joint.upper), facing < 0.0 ? -1.0 : 1.0,
                    figure.frame().in_region[hinge.value()] != 0});
  if (turns_.size() == 1) editor->viewport.active_hinge = joint.name;
}

bool RotateTool::Follow(Editor* editor, const ToolInput& input) {
  if (turns_.empty()) return false;
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord) || only_ || !axis_.Take(chord)) continue;
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
  return text + KeysHint(Tr("axis, twice: its own"));
}

}  // namespace

Result<Done> TakeRotateTool(Editor* editor) {
  if (editor->session().is_root_selected() && PoseNow(&editor->session())) {
    editor->Take(nullptr);
    TakeRootTurnTool(editor);
    return Done();
  }
  std::vector<GroupIndex> joints;
  for (const GroupIndex joint : SelectedJoints(editor->session())) {
    if (!TurnableHinges(editor->session(), joint).empty()) joints.push_back(joint);
  }
  if (joints.empty()) {
    return Error{ErrorCode::kSchema, "", "", "no joint that turns is selected: click on one"};
  }
  if (!PoseNow(&editor->session())) {
    return Error{ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
  }
  editor->Take(nullptr);
  editor->Take(std::make_unique<RotateTool>(editor, std::move(joints)));
  return Done();
}

void TakeRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held) {
  editor->Take(std::make_unique<RotateTool>(editor, ring, held));
}

}  // namespace hazumi::ui
