// Drags what a goal asks for: the place of a point, the spot of what is thrown, or the top of its
// arc. The goal is aimed again with each move; what cannot be met is said, and all stays as it was.

#include <algorithm>

#include "engine/analysis/object_landing.h"
#include "engine/base/named.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/viewport/tools/point_move_tool.h"

namespace hazumi::ui {

namespace {

// Aims a goal again, and says what came of it.
class Aimer {
 public:
  explicit Aimer(std::string goal) : goal_(std::move(goal)) {}

  // `aim`: runs goal.aim with these parameters.
  template <typename Aim>
  void Run(Editor* editor, Json wanted, Aim aim) {
    wanted["goal"] = goal_;
    const Result<Done> done = aim(wanted);
    trouble_ = done.ok() ? "" : done.error().message;
    if (!done.ok()) return;
    const AimAnswer answer = AnswerOf(editor->session());
    editor->Say(answer.text, answer.is_caution);
  }
  std::string hint() const { return trouble_.empty() ? "" : "   ! " + trouble_; }

 private:
  std::string goal_, trouble_;
};

// The place of a point, in a plane before the eye; or the top of an arc, up and down.
class GoalTool : public PointMoveTool {
 public:
  // `rise`: of the arc above the hand as the drag begins [m].
  GoalTool(Editor* editor, const GoalPart& part, double rise, HeldFrom held)
      : PointMoveTool(editor, part.goal, part.at, held),
        is_top_(part.is_top),
        rise_(rise),
        aimer_(part.goal) {
    if (is_top_) KeepToAxis('Z');
  }

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    constexpr double kLeastRise = 0.01;  // [m]
    TakeBack(editor);
    const Vec3 to = from() + offset;
    const Json wanted =
        is_top_ ? Json{{"height", std::max(kLeastRise, ToCentimetres(rise_ + offset.z()))}}
                : Json{{"x", ToCentimetres(to.x())},
                       {"y", ToCentimetres(to.y())},
                       {"z", ToCentimetres(to.z())}};
    aimer_.Run(editor, wanted, [&](const Json& all) { return Try(editor, "goal.aim", all); });
    return true;
  }
  std::string MoreHint() const override { return aimer_.hint(); }

  bool is_top_;
  double rise_;
  Aimer aimer_;
};

// The spot of what is thrown: on what is under the mouse.
class ThrownSpotTool : public DragTool {
 public:
  ThrownSpotTool(Editor* editor, const GoalPart& part, double radius)
      : DragTool(editor, "viewport.spot ", true), radius_(radius), aimer_(part.goal) {}

  std::string hint() const override {
    return Tr("Throw onto the spot under the mouse") + aimer_.hint() + "   Esc: " + Tr("cancel");
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override {
    const Animation* animation = editor->session().animation();
    if (!animation) return false;
    const View view = ViewOf(editor->viewport, editor->session().project(), editor->viewport.rect);
    const auto met = MeetsScene(view.Through(input.mouse), animation->scene);
    if (!met) return true;
    const Json wanted = {{"x", ToCentimetres(met->x())},
                         {"y", ToCentimetres(met->y())},
                         {"z", ToCentimetres(met->z()) + radius_}};
    if (wanted == wanted_) return true;
    wanted_ = wanted;
    TakeBack(editor);
    aimer_.Run(editor, wanted, [&](const Json& all) { return Try(editor, "goal.aim", all); });
    return true;
  }

  double radius_;  // of the object, from a surface to its centre [m]
  Json wanted_;
  Aimer aimer_;
};

}  // namespace

void TakeGoalTool(Editor* editor, const GoalPart& part, HeldFrom held) {
  const Project& project = editor->session().project();
  const ProjectGoal* const goal = FindNamed(project.goals, part.goal);
  const Animation* const animation = editor->session().animation();
  if (!goal || !animation) return;
  if (goal->kind == GoalKind::kPoint) {
    return editor->Take(std::make_unique<GoalTool>(editor, part, 0.0, held));
  }
  const Result<const Motion*> motion = editor->session().ShownMotionTo(goal->frame);
  if (!motion.ok()) return;
  const size_t at = static_cast<size_t>(goal->frame - animation->first_frame);
  for (size_t i = 0; i < animation->held_objects.size(); ++i) {
    const HeldObject& object = animation->held_objects[i];
    if (object.name != goal->object || at >= motion.value()->frames.size()) continue;
    const auto& objects = motion.value()->frames[at].objects;
    if (i >= objects.size()) continue;
    if (!part.is_top) {
      return editor->Take(std::make_unique<ThrownSpotTool>(editor, part, InnerRadius(object)));
    }
    const double rise = part.at.z() - objects[i].X_WO.p.z();
    return editor->Take(std::make_unique<GoalTool>(editor, part, rise, held));
  }
}

}  // namespace hazumi::ui
