// G and the handles: moves a joint by inverse kinematics. And the ends of limits.

#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"
#include "ui/edit/operators/pose/limb_chain.h"
#include "ui/panels/viewport/tools/point_move_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

class ReachTool : public PointMoveTool {
 public:
  ReachTool(Editor* editor, GroupIndex joint, const Vec3& from, std::optional<HeldFrom> held)
      : PointMoveTool(editor, editor->session().figure().group(joint).name, from, held),
        keep_turned_(edit::IsFoot(joint, editor->session().figure())) {}

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    const Vec3 to = from() + offset;
    return Run(editor, "pose.reach",
               {{"joint", name()},
                {"x", to.x()},
                {"y", to.y()},
                {"z", to.z()},
                {"keep_turned", keep_turned_}});
  }
  bool TakeKey(const Chord& chord) override {
    if (chord != Chord{'F'}) return false;
    keep_turned_ = !keep_turned_;
    return true;
  }
  std::string MoreHint() const override {
    return std::string("   F: ") + Tr(keep_turned_ ? "let it turn" : "keep how it is turned");
  }

  bool keep_turned_;
};

class LimitTool : public DragTool {
 public:
  LimitTool(Editor* editor, const GizmoHit& end)
      : DragTool(editor, "viewport.limit ", true),
        hinge_(end.hinge),
        is_upper_(end.part == GizmoPart::kUpper) {
    const Joint& joint = editor->session().figure().joint(hinge_);
    name_ = joint.name;
    angle_deg_ = ShortestDegrees(is_upper_ ? joint.upper : joint.lower);
  }

  std::string hint() const override {
    return std::string(Tr("Joint limit")) + " " + name_ + ": " + Signed(angle_deg_, 1) +
           "\u00b0    Shift: " + Tr("precise") + "   Ctrl: " + Tr("snap") +
           "   Esc: " + Tr("cancel");
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;

  JointIndex hinge_;
  bool is_upper_;
  std::string name_;
  double angle_deg_;
};

bool LimitTool::Follow(Editor* editor, const ToolInput& input) {
  const auto figure = PoseNow(&editor->session());
  if (!figure) return false;
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const auto gizmo = GizmoOf(view, editor->session(), *figure, name_, true, editor->settings.scale);
  if (!gizmo || !gizmo->arc) return false;
  const auto at = AngleAt(view, input.mouse, *gizmo->arc, angle_deg_ * kDegree);
  if (!at) return true;
  const Joint& joint = editor->session().figure().joint(hinge_);
  const double step = input.precise ? 0.1 : input.snap ? 5.0 : 1.0;
  double angle = step * std::round(*at / kDegree / step);
  angle = is_upper_ ? std::max(angle, ShortestDegrees(joint.lower))
                    : std::min(angle, ShortestDegrees(joint.upper));
  if (angle == angle_deg_) return true;
  angle_deg_ = angle;
  return Run(editor, "figure.joint_limits",
             {{"joint", name_}, {is_upper_ ? "upper" : "lower", angle}});
}

// One joint that sits on the root: it moves with it, and not by itself.
bool IsOnRoot(const std::vector<GroupIndex>& joints, const edit::Session& session) {
  const Figure& figure = session.figure();
  return joints.size() == 1 && !figure.joint(figure.group(joints[0]).first).parent.is_valid();
}

}  // namespace

Result<Done> TakeMoveTool(Editor* editor) {
  editor->Take(nullptr);
  const std::vector<GroupIndex> joints = SelectedJoints(editor->session());
  const bool moves_root =
      editor->session().is_root_selected() || IsOnRoot(joints, editor->session());
  if (joints.empty() && !moves_root) return TakeMoveObjectTool(editor, std::nullopt);
  if (moves_root && PoseNow(&editor->session())) {
    TakeRootMoveTool(editor, std::nullopt);
    return Done();
  }
  if (joints.size() > 1) {
    return Error{ErrorCode::kSchema, "", "", "one joint at a time is moved: click on one"};
  }
  const auto figure = PoseNow(&editor->session());
  if (!figure) {
    return Error{ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
  }
  editor->Take(
      std::make_unique<ReachTool>(editor, joints[0], figure->CenterOf(joints[0]), std::nullopt));
  return Done();
}

void TakeReachTool(Editor* editor, const std::string& joint, HeldFrom held) {
  const auto figure = PoseNow(&editor->session());
  const auto group = editor->session().figure().FindGroup(joint);
  if (!figure || !group) return;
  editor->Take(std::make_unique<ReachTool>(editor, *group, figure->CenterOf(*group), held));
}

void TakeLimitTool(Editor* editor, const GizmoHit& end) {
  editor->Take(std::make_unique<LimitTool>(editor, end));
}

}  // namespace hazumi::ui
