// Goals, and aims that make them come true.

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "engine/analysis/object_landing.h"
#include "engine/base/named.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/aims/aims.h"
#include "engine/makers/throws/throws.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/goals.h"
#include "engine/spatial/degrees.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/regions.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kGoal = {"goal", kText, true, "the goal's name", Thing::kGoal};

// Region in a frame that moves selected joints, else the first one there.
const ProjectRegion* LikelyRegion(const Session& session, int frame) {
  const std::set<std::string>& selected = session.selected_joints();
  const ProjectRegion* first = nullptr;
  for (const ProjectRegion& region : session.project().regions) {
    if (region.mute || frame <= region.first_frame || frame > region.last_frame) continue;
    const std::vector<bool> moved = JointsOf(region, session.figure());
    const auto is_moved = [&](const std::string& name) {
      const auto joints = FindJoints(session.figure(), name);
      return joints && moved[static_cast<size_t>(joints->first.value())];
    };
    if (std::any_of(selected.begin(), selected.end(), is_moved)) return &region;
    if (!first) first = &region;
  }
  return first;
}

// Chooses what is not given: all joints of the region there; of a point the first selected joint;
// what is let go in the frame.
void ChooseRest(const Session& session, const Parameters& p, ProjectGoal* goal) {
  const ProjectRegion* region = LikelyRegion(session, goal->frame);
  if (goal->kind == GoalKind::kPose) {
    if (p.has("joints") || !region) return;
    goal->joints = region->joints;
    std::erase_if(goal->joints, [&](const JointRef& ref) {
      return !ref.beyond && MeansRoot(ref.name, session.figure());
    });
    return;
  }
  if (goal->kind == GoalKind::kPoint && goal->joint.empty()) goal->joint = LikelyJoint(session);
  if (goal->kind != GoalKind::kObject || !goal->object.empty()) return;
  const auto& objects = session.project().held_objects;
  for (const ProjectHeldObject& object : objects) {
    goal->object = object.name;
    if (ThrowerOf(*goal, session.project())) return;
  }
  if (!objects.empty()) goal->object = objects.front().name;
}

// Fields that its kind does not have are not written.
void DropHidden(ProjectGoal* goal) {
  const ProjectGoal other;
  if (goal->kind == GoalKind::kPose) {
    goal->position_m = other.position_m;
    goal->tolerance_m = other.tolerance_m;
  } else {
    goal->joints = other.joints;
    goal->tolerance_deg = other.tolerance_deg;
  }
  if (goal->kind != GoalKind::kPoint) {
    goal->joint = other.joint;
    goal->offset_m = other.offset_m;
  }
  if (goal->kind == GoalKind::kObject) {
    goal->rests = other.rests;
  } else {
    goal->object = other.object;
    goal->height_m = other.height_m;
    goal->style = other.style;
  }
}

Result<Done> SetOwnFields(const Session& session, const Parameters& p, ProjectGoal* goal) {
  if (Result<Done> set = SetFields(p, goal); !set.ok()) return set;
  if (goal->kind == GoalKind::kPose && goal->joints.empty()) ChooseRest(session, p, goal);
  if (goal->kind != GoalKind::kPose) ChooseRest(session, p, goal);
  DropHidden(goal);
  Resolve(session.figure(), &goal->joints);
  if (goal->kind == GoalKind::kPose && goal->joints.empty()) {
    return Refusal("joints", "no dynamics region moves joints in frame " +
                                 std::to_string(goal->frame) +
                                 ": add a region over the frames before it");
  }
  return Done();
}

bool HasPlace(const Parameters& p) {
  return p.has("position_x") || p.has("position_y") || p.has("position_z");
}

// Puts the spot of a throw where the object comes to lie now, else two metres ahead on the ground.
void ChooseSpot(Session* session, ProjectGoal* goal) {
  constexpr double kAhead = 2.0;  // [m]
  const Result<const Motion*> motion = session->WholeMotion();
  const Animation* animation = session->animation();
  if (!motion.ok() || !animation) return;
  const MotionFrame& last = motion.value()->frames.back();
  for (size_t i = 0; i < animation->held_objects.size(); ++i) {
    const HeldObject& object = animation->held_objects[i];
    if (object.name != goal->object || i >= last.objects.size()) continue;
    const bool lies = !last.objects[i].is_held() && !object.keys[0].empty();
    Vec3 ahead = last.X_WR.p + kAhead * (last.X_WR.R * Vec3::UnitX());
    ahead.z() = InnerRadius(object);
    goal->position_m = lies ? last.objects[i].X_WO.p : ahead;
  }
}

// Puts the point of a goal at the tip of its joint, and where that is in the motion now.
void ChoosePlace(const Parameters& p, Session* session, ProjectGoal* goal) {
  if (HasPlace(p)) return;
  if (goal->kind == GoalKind::kObject) return ChooseSpot(session, goal);
  const auto joints = FindJoints(session->figure(), goal->joint);
  if (goal->kind != GoalKind::kPoint || !joints) return;
  const JointIndex last(joints->end.value() - 1);
  if (!p.has("offset_x") && !p.has("offset_y") && !p.has("offset_z")) {
    goal->offset_m = makers::TipOf(last, session->figure());
  }
  const Result<const Motion*> motion = session->MotionTo(goal->frame);
  if (!motion.ok()) return;
  const int at = goal->frame - session->project().frames.first;
  const auto& frames = motion.value()->frames;
  if (at < 0 || at >= static_cast<int>(frames.size())) return;
  DynamicsWorkspace ws(session->figure());
  const MotionFrame& frame = frames[static_cast<size_t>(at)];
  ComputePositions(session->figure(), frame.X_WR, frame.q, &ws);
  goal->position_m = ws.body(last).p + ws.body(last).R * goal->offset_m;
}

// Whether joints of a goal have keys behind its frame, to which they go on.
bool HasKeysAfter(const ProjectGoal& goal, const Figure& figure, const Project& project) {
  const std::vector<bool> named = HingesOf(goal, figure, project);
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!named[static_cast<size_t>(j)]) continue;
    const ProjectCurve* const curve = FindCurve(figure.joint(JointIndex(j)).name, project);
    if (curve && !curve->keys.empty() && curve->keys.back().frame > goal.frame) return true;
  }
  return false;
}

Result<Done> AddGoal(Session* session, const Parameters& p) {
  return session->Edit("Add goal", [&](Project* project) -> Result<Done> {
    ProjectGoal goal;
    goal.frame = static_cast<int>(std::lround(session->frame()));
    if (Result<Done> set = SetOwnFields(*session, p, &goal); !set.ok()) return set;
    ChoosePlace(p, session, &goal);
    const bool is_pose = goal.kind == GoalKind::kPose;
    if (is_pose && !p.has("rests")) goal.rests = !HasKeysAfter(goal, session->figure(), *project);
    if (!p.has("name")) goal.name = "goal";
    goal.name = FreeName(goal.name, project->goals);
    project->goals.push_back(std::move(goal));
    return Done();
  });
}

// Torques say by name for which goal they were found.
void RenameSolved(const std::string& from, const std::string& to, Project* project) {
  for (ProjectRegion& region : project->regions) {
    for (ProjectDrive& drive : region.drives) {
      if (drive.solved_by == from) drive.solved_by = to;
    }
  }
}

Result<Done> SetGoal(Session* session, const Parameters& p) {
  return session->Edit(
      "Change goal",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectGoal*> goal = EntryNamed(p.text("goal"), "goal", &project->goals);
        if (!goal.ok()) return goal.error();
        const GoalKind before = goal.value()->kind;
        if (Result<Done> set = SetOwnFields(*session, p, goal.value()); !set.ok()) return set;
        if (goal.value()->kind != before) ChoosePlace(p, session, goal.value());
        if (p.has("name")) {
          goal.value()->name = FreeName(goal.value()->name, project->goals, goal.value());
          RenameSolved(p.text("goal"), goal.value()->name, project);
        }
        return Done();
      },
      p.text("drag"));
}

Result<Done> RemoveGoal(Session* session, const Parameters& p) {
  return session->Edit("Remove goal", [&](Project* project) -> Result<Done> {
    auto& goals = project->goals;
    const Result<ProjectGoal*> goal = EntryNamed(p.text("goal"), "goal", &goals);
    if (!goal.ok()) return goal.error();
    // Torques of its region were found for it, too; throws have none.
    const ProjectRegion* const region =
        goal.value()->kind == GoalKind::kObject
            ? nullptr
            : makers::RegionOf(*goal.value(), session->figure(), *project);
    if (region) makers::LetLoose(&project->regions[region - project->regions.data()]);
    goals.erase(goals.begin() + (goal.value() - goals.data()));
    return Done();
  });
}

std::shared_ptr<const Figure> Figured(Session* session) {
  const Animation* const animation = session->animation();
  return animation ? animation->figure : nullptr;
}

// Takes over what an aim made, and measures it.
Result<Done> Take(Result<makers::MadeAim> made, const char* label, const Parameters& p,
                  Session* session) {
  if (!made.ok()) return made.error();
  const makers::AimReport report = made.value().report;
  Result<Done> done = Put(session, label, std::move(made.value().project), p.text("drag"));
  if (!done.ok()) return done;
  double angle = 0.0, distance = 0.0;  // the largest misses
  for (const makers::GoalMissed& missed : report.goals) {
    angle = std::max(angle, missed.angle);
    distance = std::max(distance, missed.distance);
  }
  session->Measured("off_deg", angle / kDegree);
  session->Measured("off_cm", 100.0 * distance);
  session->Measured("loose", report.is_loose ? 1.0 : 0.0);
  session->Measured("muscle", report.muscle);
  if (report.muscle > 0.0) {
    const auto joint = session->figure().FindJoint(report.strongest);
    session->Measured("strongest", joint ? joint->value() : -1.0);
    session->Measured("strongest_at", report.frame);
  }
  session->Measured("bakes", report.bakes);
  return done;
}

Vec3 PlaceGiven(const Parameters& p, const ProjectGoal& goal) {
  const Vec3& now = goal.position_m;
  return {p.number("x", now.x()), p.number("y", now.y()), p.number("z", now.z())};
}

// Throws the object of a goal anew, onto another place if that is given.
Result<Done> AimThrown(Session* session, const ProjectGoal& goal, const Parameters& p) {
  if (!ThrowerOf(goal, session->project())) {
    return Refusal("goal", "nobody lets go of \"" + goal.object + "\" in frame " +
                               std::to_string(goal.frame) +
                               ": let go of it there, or give the goal the frame of a release");
  }
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  const Animation& animation = *session->animation();
  makers::ThrowTarget target;
  for (size_t i = 0; i < animation.held_objects.size(); ++i) {
    if (animation.held_objects[i].name != goal.object) continue;
    target.object = static_cast<int>(i);
    target.spot = PlaceGiven(p, goal) - InnerRadius(animation.held_objects[i]) * Vec3::UnitZ();
    target.height = p.has("height") ? p.maybe_number("height") : goal.height_m;
    target.style = goal.style;
    Result<makers::MadeThrow> made =
        makers::AimThrow(target, goal.frame, animation, *motion.value(), session->project());
    if (!made.ok()) return made.error();
    session->Measured("muscle", made.value().report.muscle);
    return Put(session, "Aim", std::move(made.value().project), p.text("drag"));
  }
  return Refusal("object", "no held object \"" + goal.object + "\"");
}

Result<Done> Aim(Session* session, const Parameters& p) {
  const bool is_moved = p.has("x") || p.has("y") || p.has("z");
  Project project = session->project();
  ProjectGoal* const goal = FindNamed(project.goals, p.text("goal"));
  if (goal && goal->kind == GoalKind::kObject) return AimThrown(session, *goal, p);
  if (goal && goal->kind == GoalKind::kPose && is_moved) {
    return Refusal("x", "\"" + goal->name + "\" asks for a pose, which has no place");
  }
  if (p.has("height")) return Refusal("height", "only what is thrown rises to a height");
  if (goal) goal->position_m = PlaceGiven(p, *goal);
  return Take(makers::MakeAim(p.text("goal"), project, Figured(session)), "Aim", p, session);
}

Result<Done> Reach(Session* session, const Parameters& p) {
  makers::ReachTarget target;
  target.joint = p.text("joint", LikelyJoint(*session));
  target.position = {p.number("x"), p.number("y"), p.number("z")};
  target.frame =
      p.has("frame") ? p.integer("frame") : static_cast<int>(std::lround(session->frame()));
  if (p.has("rests")) target.rests = p.yes("rests");
  const std::shared_ptr<const Figure> figure = Figured(session);
  if (!figure) return Refusal("", "the project cannot be animated");
  return Take(makers::MakeReach(target, session->project(), figure), "Reach", p, session);
}

Result<Done> LetLoose(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Let loose", [](Project*, ProjectRegion* region) -> Result<Done> {
    makers::LetLoose(region);
    return Done();
  });
}

}  // namespace

std::vector<Operator> GoalOperators() {
  return {
      {"goal.add", "Add goal",
       "Adds what is to come true in a frame: joints meet their keys, a point of the body a "
       "place, or an object that is let go comes down on a spot. Default: the current frame; "
       "all joints that a region moves there.",
       Requiring({"kind"}, FieldsOf<ProjectGoal>()), AddGoal},
      {"goal.set", "Change goal", "Changes what is given of a goal.",
       Joined({{kGoal}, FieldsOf<ProjectGoal>(), {kDrag}}), SetGoal},
      {"goal.remove",
       "Remove goal",
       "Takes a goal away, and the torques that aims found for its region.",
       {kGoal},
       RemoveGoal},
      {"goal.aim",
       "Aim",
       "Finds torques for the limp joints of the region, as little as possible, with which "
       "its motion meets this goal and the region's others. Where the joints arrive by "
       "themselves they get none. An object is thrown anew: the arm's keys are found with which "
       "it comes down on its spot.",
       {kGoal,
        {"x", kNumber, false, "where its place goes before; not given: it stays"},
        {"y", kNumber, false, "where its place goes before; not given: it stays"},
        {"z", kNumber, false, "where its place goes before; not given: it stays"},
        {"height", kNumber, false, "how far what is thrown rises above the hand, metres"},
        kDrag},
       Aim},
      {"goal.reach",
       "Reach",
       "The tip of a joint's limb reaches a point in a frame: adds a goal, a dynamics region "
       "of ten frames if none moves the limb there, and aims. Default: the first selected "
       "joint; the current frame.",
       {{"joint", kText, false, "the outermost joint of the limb, a wrist", Thing::kJoint},
        {"x", kNumber, true, "of the point"},
        {"y", kNumber, true, "of the point"},
        {"z", kNumber, true, "of the point"},
        {"frame", kInteger, false, "not given: the current one"},
        {"rests", kYesNo, false, "true: what moves there stands still in that frame"},
        kDrag},
       Reach},
      {"goal.let_loose",
       "Let loose",
       "Takes away the torques that aims found for a region.",
       {kOfRegion},
       LetLoose}};
}

}  // namespace hazumi::edit
