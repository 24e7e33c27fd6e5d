// Drags what a goal asks for: the place of a point or of what is thrown, or the top of its arc. The
// goal is aimed again with each move; what cannot be met is said, and the mark stays where it was.

#include <algorithm>

#include "ui/panels/viewport/tools/point_move_tool.h"

namespace hazumi::ui {

namespace {

class GoalTool : public PointMoveTool {
 public:
  GoalTool(Editor* editor, const GoalPart& part, const ProjectGoal& goal, double rise,
           HeldFrom held)
      : PointMoveTool(editor, part.goal, part.at, held),
        is_top_(part.is_top),
        is_thrown_(goal.kind == GoalKind::kObject),
        rise_(rise) {}

 private:
  bool Place(Editor* editor, const Vec3& offset) override {
    constexpr double kLeastRise = 0.01;  // [m]
    Json wanted = {{"goal", name()}};
    if (is_top_) {
      wanted["height"] = std::max(kLeastRise, ToCentimetres(rise_ + offset.z()));
    } else {
      const Vec3 to = from() + offset;
      wanted["x"] = ToCentimetres(to.x());
      wanted["y"] = ToCentimetres(to.y());
      wanted["z"] = is_thrown_ && offset.z() == 0.0 ? to.z() : ToCentimetres(to.z());
    }
    const Result<Done> done = Try(editor, "goal.aim", wanted);
    trouble_ = done.ok() ? "" : done.error().message;
    if (done.ok()) {
      const AimAnswer answer = AnswerOf(editor->session());
      editor->Say(answer.text, answer.is_caution);
    }
    return true;
  }
  // What is thrown comes down on the ground; the top of an arc is above that.
  Vec3 PlaneOf(const View& view) const override {
    if (!is_thrown_) return view.back();
    if (!is_top_) return Vec3::UnitZ();
    Vec3 level = view.back();
    level.z() = 0.0;
    return level.norm() > 1e-6 ? Vec3(level.normalized()) : Vec3(Vec3::UnitX());
  }
  std::string MoreHint() const override { return trouble_.empty() ? "" : "   ! " + trouble_; }

  bool is_top_, is_thrown_;
  double rise_;  // of the arc above the hand as the drag begins [m]
  std::string trouble_;
};

}  // namespace

void TakeGoalTool(Editor* editor, const GoalPart& part, HeldFrom held) {
  const Project& project = editor->session().project();
  for (const ProjectGoal& goal : project.goals) {
    if (goal.name != part.goal) continue;
    double rise = 0.0;
    const Result<const Motion*> motion = editor->session().ShownMotionTo(goal.frame);
    if (part.is_top && motion.ok()) {
      for (size_t i = 0; i < project.held_objects.size(); ++i) {
        const size_t at = static_cast<size_t>(goal.frame - project.frames.first);
        if (project.held_objects[i].name != goal.object || at >= motion.value()->frames.size()) {
          continue;
        }
        rise = part.at.z() - motion.value()->frames[at].objects[i].X_WO.p.z();
      }
    }
    editor->Take(std::make_unique<GoalTool>(editor, part, goal, rise, held));
    return;
  }
}

}  // namespace hazumi::ui
