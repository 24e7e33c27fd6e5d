// G and the handles: moves a joint by inverse kinematics, or an object. And the ends of limits.

#include <algorithm>
#include <cmath>

#include "ui/panels/viewport_drag_tool.h"
#include "ui/panels/viewport_tools.h"

namespace hazumi::ui {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kStep = 0.05;  // with Ctrl [m]

// How far along an axis through `p` the line through the mouse passes it [m].
double AlongAxis(const View& view, Point at, const Vec3& p, const Vec3& axis) {
  const Ray ray = view.Through(at);
  const double c = axis.dot(ray.direction), denominator = 1.0 - c * c;
  if (denominator < 1e-4) return 0.0;
  const Vec3 w = p - ray.from;
  return (c * w.dot(ray.direction) - w.dot(axis)) / denominator;
}

// Moves a point, in the plane of the view or along an axis of the world.
class MoveTool : public DragTool {
 public:
  MoveTool(Editor* editor, std::string name, const Vec3& from, std::optional<HeldFrom> held)
      : DragTool(editor, "viewport.move ", held.has_value()), name_(std::move(name)), from_(from) {
    if (!held) return;
    BeginAt(held->mouse);
    start_ = mouse_ = held->mouse;
  }

  std::string hint() const override {
    std::string text = std::string(Tr("Move")) + " " + name_ + ": ";
    if (!typed_.is_empty()) {
      text += std::string(1, axis_ ? axis_ : 'X') + " " + typed_.shown() + " m";
    } else {
      for (int i = 0; i < 3; ++i) {
        text += std::string(i ? "  " : "") + "XYZ"[i] + " " + Signed(offset_[i], 3);
      }
      text += " m";
    }
    return text + KeysHint(Tr("axis"));
  }

 protected:
  // To where it was plus `offset` [m].
  virtual bool Place(Editor* editor, const Vec3& offset) = 0;

  std::string name_;
  Vec3 from_;

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  Vec3 OffsetOf(const View& view, bool snap) const;

  char axis_ = 0;  // 'X' to 'Z' once it was typed
  std::optional<Point> start_;
  Point mouse_;  // moves as the mouse does, slower with Shift
  Vec3 offset_ = Vec3::Zero();
  TypedNumber typed_;
};

Vec3 MoveTool::OffsetOf(const View& view, bool snap) const {
  Vec3 offset = Vec3::Zero();
  const Vec3 axis = Vec3::Unit((axis_ ? axis_ : 'X') - 'X');
  if (!typed_.is_empty()) return typed_.value() * axis;
  if (axis_) {
    offset = (AlongAxis(view, mouse_, from_, axis) - AlongAxis(view, *start_, from_, axis)) * axis;
  } else {
    const auto to = view.OnPlane(mouse_, from_, view.back());
    const auto from = view.OnPlane(*start_, from_, view.back());
    if (to && from) offset = *to - *from;
  }
  if (!snap) return offset;
  return (offset / kStep).array().round().matrix() * kStep;
}

bool MoveTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord) || chord.key < 'X' || chord.key > 'Z') continue;
    axis_ = static_cast<char>(chord.key);
  }
  if (!start_) start_ = mouse_ = input.mouse;
  const Point by = MouseMoved(input);
  mouse_ = {mouse_.x + by.x, mouse_.y + by.y};
  const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
  const Vec3 offset = OffsetOf(view, input.snap);
  if (offset == offset_) return true;
  offset_ = offset;
  return Place(editor, offset);
}

class ReachTool : public MoveTool {
 public:
  using MoveTool::MoveTool;

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    const Vec3 to = from_ + offset;
    return Run(editor, "pose.reach",
               {{"joint", name_}, {"x", to.x()}, {"y", to.y()}, {"z", to.z()}});
  }
};

class ObjectTool : public MoveTool {
 public:
  using MoveTool::MoveTool;

 private:
  // The operator adds to where the object is: each time from the beginning.
  bool Place(Editor* editor, const Vec3& offset) override {
    TakeBack(editor);
    return Run(editor, "object.move",
               {{"object", name_}, {"x", offset.x()}, {"y", offset.y()}, {"z", offset.z()}});
  }
};

class LimitTool : public DragTool {
 public:
  LimitTool(Editor* editor, const GizmoHit& end)
      : DragTool(editor, "viewport.limit ", true),
        hinge_(end.hinge),
        is_upper_(end.part == GizmoPart::kUpper) {
    const Joint& joint = editor->session().figure().joint(hinge_);
    name_ = joint.name;
    angle_deg_ = (is_upper_ ? joint.upper : joint.lower) / kDegree;
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
  angle =
      is_upper_ ? std::max(angle, joint.lower / kDegree) : std::min(angle, joint.upper / kDegree);
  if (angle == angle_deg_) return true;
  angle_deg_ = angle;
  return Run(editor, "figure.joint_limits",
             {{"joint", name_}, {is_upper_ ? "upper" : "lower", angle}});
}

Result<Done> TakeObjectTool(Editor* editor) {
  const std::string& name = editor->viewport.selected_object;
  for (const ProjectSceneObject& object : editor->session().project().scene.objects) {
    const auto* box = std::get_if<ProjectBox>(&object.shape);
    if (object.name != name || !box) continue;
    editor->Take(std::make_unique<ObjectTool>(editor, name, box->center_m, std::nullopt));
    return Done();
  }
  return Error{ErrorCode::kSchema, "", "", "nothing is selected: click on a joint or a box"};
}

}  // namespace

Result<Done> TakeMoveTool(Editor* editor) {
  editor->Take(nullptr);
  const std::vector<GroupIndex> joints = SelectedJoints(editor->session());
  if (joints.empty()) return TakeObjectTool(editor);
  if (joints.size() > 1) {
    return Error{ErrorCode::kSchema, "", "", "one joint at a time is moved: click on one"};
  }
  const auto figure = PoseNow(&editor->session());
  if (!figure) {
    return Error{ErrorCode::kSemantics, "", "", "the project cannot be animated as it is"};
  }
  const std::string name = figure->figure().group(joints[0]).name;
  editor->Take(
      std::make_unique<ReachTool>(editor, name, figure->CenterOf(joints[0]), std::nullopt));
  return Done();
}

void TakeReachTool(Editor* editor, const std::string& joint, HeldFrom held) {
  const auto figure = PoseNow(&editor->session());
  const auto group = editor->session().figure().FindGroup(joint);
  if (!figure || !group) return;
  editor->Take(std::make_unique<ReachTool>(editor, joint, figure->CenterOf(*group), held));
}

void TakeLimitTool(Editor* editor, const GizmoHit& end) {
  editor->Take(std::make_unique<LimitTool>(editor, end));
}

}  // namespace hazumi::ui
