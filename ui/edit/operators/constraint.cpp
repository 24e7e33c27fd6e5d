// Constraints: what keeps things together while dynamics moves them.

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/base/named.h"
#include "engine/collision/distance.h"
#include "engine/collision/shapes.h"
#include "engine/dynamics/kinematics.h"
#include "engine/project/checks/joint_names.h"
#include "engine/spatial/euler_angles.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/objects.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

constexpr double kNoGap = 1e-4;     // [m]
constexpr double kRodLength = 0.3;  // of a rod that hangs from nothing yet [m]
constexpr int kArriveFrames = 5;    // of a hand that takes hold

constexpr const char* kPlaces[] = {"x", "y", "z"};
const ParameterInfo kConstraint = {"constraint", kText, true, "the constraint's name",
                                   Thing::kConstraint};

// Where things are in the current frame.
class Places {
 public:
  static Result<Places> Now(Session* session) {
    const Result<const MotionFrame*> now = session->FrameNow();
    if (!now.ok()) return now.error();
    return Places(*session->animation(), *now.value());
  }

  // Of what an end is fixed to; what is not there is refused when the project is compiled.
  hazumi::Pose FrameOf(const ProjectConstraintEnd& end) const {
    const auto meant = FindJoints(figure(), end.joint);
    if (meant) return BodyOf(figure().group(meant->group).last());
    if (!end.joint.empty()) return now_.X_WR;
    if (const SceneObject* object = FindNamed(animation_.scene, end.object)) {
      return hazumi::FrameOf(object->shape);
    }
    const HeldObject* held = FindNamed(animation_.held_objects, end.object);
    if (!held) return {};
    return now_.objects[static_cast<size_t>(held - animation_.held_objects.data())].X_WO;
  }
  hazumi::Pose PoseOf(const ProjectConstraintEnd& end) const {
    return FrameOf(end) * hazumi::Pose{TurnOf(end.rotation_deg), end.offset_m};
  }

  // Puts an end where it is in the world, as seen from what it is fixed to.
  void PutPlace(const Vec3& at, ProjectConstraintEnd* end) const {
    end->offset_m = FrameOf(*end).Inverse() * at;
    for (double& x : end->offset_m) x = WithoutRoundOff(x);
  }
  void PutTurn(const Mat3& R, ProjectConstraintEnd* end) const {
    const Mat3 own = FrameOf(*end).R.transpose() * R;
    end->rotation_deg = EulerAnglesNear(own, {2, 1, 0}, Vec3::Zero()) / kDegree;
    for (double& angle : end->rotation_deg) angle = WithoutRoundOff(angle);
  }

  double Gap(const ProjectConstraint& constraint) const {
    return (PoseOf(constraint.a).p - PoseOf(constraint.b).p).norm();
  }
  // The point of an object's surface that is nearest to a point.
  Vec3 NearestOn(const ProjectConstraintEnd& end, const Vec3& p) const {
    if (const SceneObject* solid = FindNamed(animation_.scene, end.object)) {
      return OnSurface(solid->shape, p);
    }
    const HeldObject* held = FindNamed(animation_.held_objects, end.object);
    if (!held) return p;
    const hazumi::Pose X_WO = FrameOf(end);
    if (const auto* box = std::get_if<BoxShape>(&held->shape)) {
      return OnSurface(Box{X_WO, box->half_size}, p);
    }
    const double radius = std::get<SphereShape>(held->shape).radius;
    return X_WO.p + radius * (p - X_WO.p).stableNormalized();
  }

 private:
  Places(const Animation& animation, const MotionFrame& now)
      : animation_(animation), now_(now), ws_(*animation.figure) {
    ComputePositions(figure(), now.X_WR, now.q, &ws_);
  }

  static Vec3 OnSurface(const Obstacle& solid, const Vec3& p) {
    const Distance distance = SignedDistance(Capsule{p, p, 0.0}, solid);
    return distance.point_on_capsule - distance.value * distance.normal;
  }

  const Figure& figure() const { return *animation_.figure; }
  hazumi::Pose BodyOf(JointIndex j) const { return {ws_.body(j).R, ws_.body(j).p}; }

  const Animation& animation_;
  const MotionFrame& now_;
  DynamicsWorkspace ws_;
};

// The parameters of an end.
struct EndParameters {
  const char *joint, *object, *offset, *angle;
};
constexpr EndParameters kOfA = {"a_joint", "a_object", "a_offset_", "a_angle_"};
constexpr EndParameters kOfB = {"b_joint", "b_object", "b_offset_", "b_angle_"};

bool HasAny(const char* beginning, const Parameters& p) {
  for (const auto& item : p.values().items()) {
    if (item.key().starts_with(beginning)) return true;
  }
  return false;
}

// What it is fixed to now goes, if it is fixed to something else.
void LetGoOf(const EndParameters& of, const Parameters& p, ProjectConstraintEnd* end) {
  if (!p.text(of.joint).empty() && !p.has(of.object)) end->object.clear();
  if (!p.text(of.object).empty() && !p.has(of.joint)) end->joint.clear();
}

Result<Done> SetOwnFields(const Parameters& p, ProjectConstraint* constraint) {
  LetGoOf(kOfA, p, &constraint->a);
  LetGoOf(kOfB, p, &constraint->b);
  return SetFields(p, constraint);
}

// An end that is fixed to something else stays where it is, unless that is given.
void Stay(const EndParameters& of, const Parameters& p, const ProjectConstraintEnd& before,
          const Places& places, ProjectConstraintEnd* end) {
  if (end->joint == before.joint && end->object == before.object) return;
  const hazumi::Pose X = places.PoseOf(before);
  if (!HasAny(of.offset, p)) places.PutPlace(X.p, end);
  if (!HasAny(of.angle, p)) places.PutTurn(X.R, end);
}

// Joints of which a hinge is selected, and the root.
std::vector<std::string> SelectedJoints(const Session& session) {
  const Figure& figure = session.figure();
  const std::set<std::string>& selected = session.selected_joints();
  std::vector<std::string> names;
  for (const JointGroup& joint : figure.groups()) {
    for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
      if (!selected.contains(figure.joints()[j].name)) continue;
      names.push_back(joint.name);
      break;
    }
  }
  if (selected.contains(figure.root_name())) names.push_back(figure.root_name());
  return names;
}

// Of those that are not given: the first selected joint, and the second one, or where the first is
// in the world; a rod hangs from above.
void ChooseEnds(const Session& session, const Parameters& p, const Places& places,
                ProjectConstraint* constraint) {
  const bool has_a = HasAny("a_", p), has_b = HasAny("b_", p);
  const std::vector<std::string> selected = SelectedJoints(session);
  if (!has_a) constraint->a.joint = selected.empty() ? LikelyJoint(session) : selected[0];
  if (has_b) return;
  if (!has_a && selected.size() > 1) {
    constraint->b.joint = selected[1];
    return;
  }
  Vec3 at = places.PoseOf(constraint->a).p;
  if (constraint->kind == ConstraintKind::kDistance) {
    at.z() += p.number("length", kRodLength);
  }
  places.PutPlace(at, &constraint->b);
}

// A weld keeps things as they are; a rod is as long as it has to be.
void Fit(const Parameters& p, const Places& places, ProjectConstraint* constraint) {
  const hazumi::Pose X_WA = places.PoseOf(constraint->a);
  if (constraint->kind == ConstraintKind::kWeld) {
    if (!HasAny(kOfB.offset, p)) places.PutPlace(X_WA.p, &constraint->b);
    if (!HasAny(kOfB.angle, p)) places.PutTurn(X_WA.R, &constraint->b);
  }
  if (constraint->kind == ConstraintKind::kDistance && !p.has("length")) {
    constraint->length_m = WithoutRoundOff(places.Gap(*constraint));
  }
}

// From the current frame to the last one.
ProjectConstraint NewConstraint(const Session& session) {
  ProjectConstraint constraint;
  constraint.first_frame = static_cast<int>(std::lround(session.frame()));
  constraint.last_frame = session.project().frames.last;
  return constraint;
}

// Resets fields that the file does not say of this kind: a project that is opened again has to be
// the same.
void DropHidden(ProjectConstraint* constraint) {
  if (constraint->kind != ConstraintKind::kDistance) constraint->length_m = 0.0;
  if (constraint->kind == ConstraintKind::kWeld) return;
  constraint->a.rotation_deg = constraint->b.rotation_deg = Vec3::Zero();
}

void Put(ProjectConstraint constraint, const Parameters& p, Project* project) {
  DropHidden(&constraint);
  if (!p.has("name")) constraint.name = hazumi::NameOf(constraint.kind);
  constraint.name = FreeName(constraint.name, project->constraints);
  project->constraints.push_back(std::move(constraint));
}

Result<Done> AddConstraint(Session* session, const Parameters& p) {
  const Result<Places> places = Places::Now(session);
  if (!places.ok()) return places.error();
  return session->Edit("Add constraint", [&](Project* project) -> Result<Done> {
    ProjectConstraint constraint = NewConstraint(*session);
    if (Result<Done> set = SetOwnFields(p, &constraint); !set.ok()) return set;
    ChooseEnds(*session, p, places.value(), &constraint);
    Fit(p, places.value(), &constraint);
    Put(std::move(constraint), p, project);
    return Done();
  });
}

// Whether what is given has to do with where things are: those that drag a number need not wait.
bool AsksForPlaces(const Parameters& p) {
  const auto names = {kOfA.joint, kOfA.object, kOfB.joint, kOfB.object, "kind"};
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return p.has(name); });
}

Result<Done> SetConstraint(Session* session, const Parameters& p) {
  std::optional<Places> places;
  if (AsksForPlaces(p)) {
    if (Result<Places> now = Places::Now(session); now.ok()) places.emplace(std::move(now).value());
  }
  return session->Edit(
      "Change constraint",
      [&](Project* project) -> Result<Done> {
        auto& constraints = project->constraints;
        const Result<ProjectConstraint*> found =
            EntryNamed(p.text("constraint"), "constraint", &constraints);
        if (!found.ok()) return found.error();
        ProjectConstraint& constraint = *found.value();
        const ProjectConstraint before = constraint;
        if (p.yes("no_gap")) constraint.arrive_frames.reset();
        if (p.yes("unbreakable")) {
          constraint.break_force_n.reset();
          constraint.break_impulse_n_s.reset();
        }
        if (Result<Done> set = SetOwnFields(p, &constraint); !set.ok()) return set;
        if (p.has("name")) constraint.name = FreeName(constraint.name, constraints, &constraint);
        if (places) {
          Stay(kOfA, p, before.a, *places, &constraint.a);
          Stay(kOfB, p, before.b, *places, &constraint.b);
          if (constraint.kind != before.kind) Fit(p, *places, &constraint);
        }
        DropHidden(&constraint);
        return Done();
      },
      p.text("drag"));
}

Result<Done> RemoveConstraint(Session* session, const Parameters& p) {
  return session->Edit("Remove constraint", [&](Project* project) -> Result<Done> {
    auto& constraints = project->constraints;
    const Result<ProjectConstraint*> constraint =
        EntryNamed(p.text("constraint"), "constraint", &constraints);
    if (!constraint.ok()) return constraint.error();
    constraints.erase(constraints.begin() + (constraint.value() - constraints.data()));
    return Done();
  });
}

// Where on it is given, or else where the joint is nearest to it.
Result<Done> HoldOn(Session* session, const Parameters& p) {
  const Result<GroupIndex> joint = HolderGiven(*session, p);
  if (!joint.ok()) return joint.error();
  const Result<Places> places = Places::Now(session);
  if (!places.ok()) return places.error();
  return session->Edit("Hold on", [&](Project* project) -> Result<Done> {
    ProjectConstraint constraint = NewConstraint(*session);
    if (Result<Done> set = SetFields(p, &constraint); !set.ok()) return set;
    constraint.a.joint = session->figure().group(joint.value()).name;
    constraint.b.object = p.text("object");
    Vec3 near = places.value().PoseOf(constraint.a).p;
    for (int axis = 0; axis < 3; ++axis) near[axis] = p.number(kPlaces[axis], near[axis]);
    places.value().PutPlace(places.value().NearestOn(constraint.b, near), &constraint.b);
    if (!p.has("arrive") && places.value().Gap(constraint) >= kNoGap) {
      constraint.arrive_frames = kArriveFrames;
    }
    Put(std::move(constraint), p, project);
    return Done();
  });
}

ParameterInfo PlaceOn(int axis) {
  return {kPlaces[axis],
          kNumber,
          false,
          "where on it; not given: where the joint is nearest to it",
          {},
          "",
          "m"};
}

template <typename Action>
void ForEachEnd(Project* project, Action action) {
  for (ProjectConstraint& constraint : project->constraints) {
    for (ProjectConstraintEnd* end : {&constraint.a, &constraint.b}) action(end);
  }
}

}  // namespace

void RenameObject(const std::string& from, const std::string& to, Project* project) {
  ForEachEnd(project, [&](ProjectConstraintEnd* end) {
    if (end->object == from) end->object = to;
  });
  for (ProjectGoal& goal : project->goals) {
    if (goal.object == from) goal.object = to;
  }
}

Result<Done> ExpectUnconstrained(const std::string& object, const Project& project) {
  for (const ProjectConstraint& constraint : project.constraints) {
    if (constraint.a.object != object && constraint.b.object != object) continue;
    return Refusal("object", "the constraint \"" + constraint.name +
                                 "\" is fixed to it; remove that first, or fix it to something "
                                 "else");
  }
  return Done();
}

std::vector<Operator> ConstraintOperators() {
  const ParameterInfos fields = FieldsOf<ProjectConstraint>();
  return {
      {"constraint.add", "Add constraint",
       "Keeps two ends together, which regions of method exact feel. Not given: from the current "
       "frame on; the first selected joint and the second one, or where the first is in the "
       "world. A weld keeps the ends as they are, a distance is what it is now.",
       Requiring({"kind"}, fields), AddConstraint},
      {"constraint.set", "Change constraint",
       "Changes what is given of a constraint. An end that is fixed to something else stays where "
       "it is, unless that is given.",
       Joined({{kConstraint},
               fields,
               {{"no_gap", kYesNo, false, "true: there is no gap that has to close"},
                {"unbreakable", kYesNo, false, "true: nothing breaks it"},
                kDrag}}),
       SetConstraint},
      {"constraint.remove",
       "Remove constraint",
       "Takes a constraint away.",
       {kConstraint},
       RemoveConstraint},
      {"constraint.hold_on", "Hold on to object",
       "A joint takes hold of an object, of the scene or held, from the current frame on. Not "
       "given: the selected joint, which gets there in 5 frames.",
       Joined({{{"object", kText, true, "the object's name", Thing::kSceneOrHeldObject},
                {"joint", kText, false, "not given: the selected one", Thing::kJoint},
                PlaceOn(0),
                PlaceOn(1),
                PlaceOn(2)},
               Only({"name", "first", "last", "arrive", "break_force", "break_impulse"}, fields)}),
       HoldOn}};
}

}  // namespace hazumi::edit
