// Drags what a goal asks for: the place of a point, the spot of what is thrown, or the top of its
// arc. The goal is aimed again with each move; what cannot be met is said, and all stays as it was.

#include <algorithm>
#include <cmath>
#include <optional>

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
  bool Run(Editor* editor, Json wanted, Aim aim) {
    wanted["goal"] = goal_;
    const Result<Done> done = aim(wanted);
    trouble_ = done.ok() ? "" : done.error().message;
    if (!done.ok()) return false;
    const AimAnswer answer = AnswerOf(editor->session());
    editor->Say(answer.text, answer.is_caution);
    return true;
  }
  std::string hint() const { return trouble_.empty() ? "" : "   ! " + trouble_; }

 private:
  std::string goal_, trouble_;
};

// The place of a point, in a plane before the eye; or the top of an arc, up and down.
class GoalTool : public PointMoveTool {
 public:
  // `object`: of the session's held objects, of an arc; `release`: frame in which it is let go.
  GoalTool(Editor* editor, const GoalPart& part, size_t object, int release, HeldFrom held)
      : PointMoveTool(editor, part.goal, part.at, held),
        is_top_(part.is_top),
        object_(object),
        release_(release),
        aimer_(part.goal) {
    if (is_top_) KeepToAxis('Z');
  }

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    const Vec3 to = from() + offset;
    if (is_top_) {
      RiseTo(editor, to.z());
      return true;
    }
    Aim(editor,
        {{"x", ToCentimetres(to.x())}, {"y", ToCentimetres(to.y())}, {"z", ToCentimetres(to.z())}});
    return true;
  }

  // A rise counts from the hand, which lets go in another place for each of them.
  void RiseTo(Editor* editor, double top) {
    constexpr double kLeastRise = 0.01, kNear = 0.01;  // [m]
    constexpr int kTries = 3;
    double last = -1.0;
    for (int i = 0; i < kTries; ++i) {
      const std::optional<double> hand = HandNow(editor);
      if (!hand) return;
      const double rise = std::max(kLeastRise, ToCentimetres(top - *hand));
      if (std::abs(rise - last) < kNear) return;
      last = rise;
      if (!Aim(editor, {{"height", rise}})) return;
    }
  }

  // Height of the object as it is let go [m].
  std::optional<double> HandNow(Editor* editor) const {
    const Result<const Motion*> motion = editor->session().MotionTo(release_);
    if (!motion.ok()) return std::nullopt;
    const auto& frames = motion.value()->frames;
    const size_t at = static_cast<size_t>(release_ - frames.front().frame);
    if (at >= frames.size() || object_ >= frames[at].objects.size()) return std::nullopt;
    return frames[at].objects[object_].X_WO.p.z();
  }

  bool Aim(Editor* editor, const Json& wanted) {
    TakeBack(editor);
    return aimer_.Run(editor, wanted,
                      [&](const Json& all) { return Try(editor, "goal.aim", all); });
  }
  std::string MoreHint() const override { return aimer_.hint(); }

  bool is_top_;
  size_t object_;
  int release_;
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
    return editor->Take(std::make_unique<GoalTool>(editor, part, 0, goal->frame, held));
  }
  for (size_t i = 0; i < animation->held_objects.size(); ++i) {
    const HeldObject& object = animation->held_objects[i];
    if (object.name != goal->object) continue;
    if (part.is_top) {
      return editor->Take(std::make_unique<GoalTool>(editor, part, i, goal->frame, held));
    }
    return editor->Take(std::make_unique<ThrownSpotTool>(editor, part, InnerRadius(object)));
  }
}

}  // namespace hazumi::ui
