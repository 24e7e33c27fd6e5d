#include "ui/panels/viewport/goal_marks.h"

#include <algorithm>
#include <cmath>

#include "engine/base/filled.h"
#include "engine/base/named.h"
#include "engine/project/checks/joint_names.h"
#include "ui/panels/viewport/hit_test.h"

namespace hazumi::ui {

namespace {

// Index of a held object; -1: there is none of that name.
int ObjectNamed(const std::string& name, const Project& project) {
  const ProjectHeldObject* const object = FindNamed(project.held_objects, name);
  return object ? static_cast<int>(object - project.held_objects.data()) : -1;
}

// First frame in which what is let go in a frame lies on a key of its own.
int DownAfter(int release, const ProjectHeldObject& object) {
  for (const ProjectKey& key : object.position.curves[0].keys) {
    if (key.frame > release) return static_cast<int>(key.frame);
  }
  return release;
}

}  // namespace

std::vector<GoalMark> GoalMarks(const Project& project, const PosedFigure& figure) {
  std::vector<GoalMark> marks;
  const double fps = static_cast<double>(project.fps.num) / project.fps.den;
  for (size_t i = 0; i < project.goals.size(); ++i) {
    const ProjectGoal& goal = project.goals[i];
    GoalMark mark;
    mark.index = static_cast<int>(i);
    mark.frames = goal.frame - figure.frame().frame;
    mark.place = goal.position_m;
    if (goal.kind == GoalKind::kPose || mark.frames > fps) continue;
    if (goal.kind == GoalKind::kPoint) {
      const auto joints = FindJoints(figure.figure(), goal.joint);
      if (!joints || mark.frames < 0) continue;
      mark.point = figure.PoseOf(JointIndex(joints->end.value() - 1)) * goal.offset_m;
    } else {
      const int object = ObjectNamed(goal.object, project);
      if (object < 0) continue;
      const size_t at = static_cast<size_t>(object);
      const int down = DownAfter(goal.frame, project.held_objects[at]);
      // What is shown may be older than the project.
      if (at >= figure.frame().objects.size()) continue;
      if (figure.frame().frame > std::max(goal.frame, down)) continue;
      mark.point = figure.frame().objects[at].X_WO.p;
    }
    marks.push_back(mark);
  }
  return marks;
}

void FindTops(const Project& project, const Motion& motion, double gravity,
              std::vector<GoalMark>* marks) {
  const double h = motion.rate.SecondsAt(1);
  for (GoalMark& mark : *marks) {
    const ProjectGoal& goal = project.goals[static_cast<size_t>(mark.index)];
    const int object = ObjectNamed(goal.object, project);
    if (goal.kind != GoalKind::kObject || object < 0 || motion.frames.empty()) continue;
    const size_t at = static_cast<size_t>(goal.frame - motion.frames[0].frame);
    if (goal.frame < motion.frames[0].frame || at + 1 >= motion.frames.size()) continue;
    if (static_cast<size_t>(object) >= motion.frames[at].objects.size()) continue;
    const auto pose = [&](size_t frame) -> const ObjectPose& {
      return motion.frames[frame].objects[static_cast<size_t>(object)];
    };
    if (pose(at).is_held()) continue;
    const Vec3 p = pose(at).X_WO.p;
    const Vec3 v = (pose(at + 1).X_WO.p - p) / h + Vec3(0.0, 0.0, 0.5 * gravity * h);
    if (!(gravity > 0.0)) continue;
    const double t = std::max(0.0, v.z()) / gravity;
    mark.top = p + t * v - Vec3(0.0, 0.0, 0.5 * gravity * t * t);
  }
}

std::string TextOf(const GoalMark& mark, const Project& project) {
  const ProjectGoal& goal = project.goals[static_cast<size_t>(mark.index)];
  if (mark.frames > 0) return goal.name + ": " + Filled(Tr("in %d frames"), mark.frames);
  if (goal.kind == GoalKind::kObject) return goal.name;
  return goal.name + ": " + Filled(Tr("%.1f cm off"), 100.0 * (mark.point - mark.place).norm());
}

std::optional<GoalPart> GoalPartAt(const View& view, Point mouse,
                                   const std::vector<GoalMark>& marks, const Project& project,
                                   double scale) {
  const auto is_under = [&](const Vec3& place) {
    const std::optional<Point> at = view.ToWindow(place);
    return at && std::hypot(at->x - mouse.x, at->y - mouse.y) < kMarkerReach * scale;
  };
  for (const GoalMark& mark : marks) {
    const std::string& name = project.goals[static_cast<size_t>(mark.index)].name;
    if (is_under(mark.place)) return GoalPart{name, false, mark.place};
    if (mark.top && is_under(*mark.top)) return GoalPart{name, true, *mark.top};
  }
  return std::nullopt;
}

std::vector<GoalMark> GoalMarksNow(Editor* editor, const PosedFigure& figure) {
  const Animation* animation = editor->session().animation();
  if (!editor->viewport.overlays.forces || !animation) return {};
  const Project& project = editor->session().project();
  std::vector<GoalMark> marks = GoalMarks(project, figure);
  int last = figure.frame().frame;
  for (const GoalMark& mark : marks) {
    const ProjectGoal& goal = project.goals[static_cast<size_t>(mark.index)];
    if (goal.kind == GoalKind::kObject) last = std::max(last, goal.frame + 1);
  }
  last = std::min(last, animation->last_frame);
  const Result<const Motion*> motion = editor->session().ShownMotionTo(last);
  if (motion.ok()) FindTops(project, *motion.value(), animation->gravity, &marks);
  return marks;
}

}  // namespace hazumi::ui
