// Objects that joints hold until they let go.

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "engine/dynamics/kinematics.h"
#include "engine/exchange/import/thing_mesh.h"
#include "engine/exchange/read_character.h"
#include "engine/project/edits/holders.h"
#include "engine/spatial/euler_angles.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/objects.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kObject = {"object", kText, true, "the held object's name", Thing::kHeldObject};

template <typename Shape>
ProjectHeldObject NewObject(Shape shape, const char* name) {
  ProjectHeldObject object;
  object.name = name;
  object.shape = std::move(shape);
  object.mass_kg = 0.145;
  object.color = "#e8792b";
  return object;
}
constexpr double kThinnest = 1e-3;  // side of the box around a mesh [m]

// As large and as heavy as a baseball.
ProjectHeldObject NewBall() { return NewObject(ProjectSphereShape{0.037, {}}, "ball"); }
ProjectHeldObject NewBox() { return NewObject(ProjectBoxShape{Vec3(0.1, 0.1, 0.1), {}}, "box"); }

// Of balls and boxes.
ParameterInfos FieldsOfShapes() {
  return Joined({FieldsOf(NewBall()), Only({"size_x", "size_y", "size_z"}, FieldsOf(NewBox()))});
}

// From a holder's bones to the centre of what lies at its surface.
double RadiusOf(const ProjectSphereShape& sphere, const Mat3&) { return sphere.radius_m; }
double RadiusOf(const ProjectBoxShape& box, const Mat3& R) {
  return 0.5 * R.row(1).cwiseAbs().dot(box.size_m);
}

bool IsOffsetGiven(const Parameters& p) {
  return p.has("offset_x") || p.has("offset_y") || p.has("offset_z");
}

// Half a metre before the root, on the ground.
Vec3 BeforeTheFigure(const ProjectHeldObject& object) {
  constexpr double kBefore = 0.5;  // [m]
  if (const auto* sphere = std::get_if<ProjectSphereShape>(&object.shape)) {
    return {kBefore, 0.0, sphere->radius_m};
  }
  return {kBefore, 0.0, 0.5 * std::get<ProjectBoxShape>(object.shape).size_m.z()};
}

// In a hand, or, if none is named or selected, on the ground.
Result<Done> AddHeld(Session* session, const Parameters& p, ProjectHeldObject object) {
  const bool is_held = p.has("joint") || !FirstSelectedJoint(*session).empty();
  const Result<GroupIndex> holder = is_held ? HolderGiven(*session, p) : GroupIndex();
  if (!holder.ok()) return holder.error();
  return session->Edit("Add held object", [&](Project* project) -> Result<Done> {
    if (Result<Done> set = SetFields(p, &object); !set.ok()) return set;
    object.name = FreeObjectName(object.name, *project);
    if (!is_held) {
      const Vec3 at = BeforeTheFigure(object);
      for (int axis = 0; axis < 3; ++axis) {
        ProjectKey key;
        key.frame = project->frames.first;
        key.value = at[axis];
        object.position.curves[axis].keys = {key};
      }
    } else {
      object.joint = session->figure().group(holder.value()).name;
      if (!IsOffsetGiven(p)) {
        object.offset_m = InThePalm(session->figure(), holder.value(), object, object.rotation_deg);
      }
    }
    project->held_objects.push_back(std::move(object));
    return Done();
  });
}

Result<Done> AddHeldBall(Session* session, const Parameters& p) {
  return AddHeld(session, p, NewBall());
}
Result<Done> AddHeldBox(Session* session, const Parameters& p) {
  return AddHeld(session, p, NewBox());
}

// Solid as the box around it.
Result<Done> AddHeldMesh(Session* session, const Parameters& p) {
  const Result<Character> read = ReadThing(p.text("path"));
  if (!read.ok()) return read.error();
  ThingMesh mesh = MeshOfThing(read.value());
  ProjectHeldObject object =
      NewObject(ProjectBoxShape{mesh.size.cwiseMax(kThinnest), {}}, read.value().name.c_str());
  object.mesh.skin = std::make_shared<const Skin>(std::move(mesh.skin));
  return AddHeld(session, p, std::move(object));
}

Result<Done> SetHeld(Session* session, const Parameters& p) {
  return ChangeHeld(
      session, p, "Change held object", [&](ProjectHeldObject* object) -> Result<Done> {
        const bool is_ball = std::holds_alternative<ProjectSphereShape>(object->shape);
        Result<Done> own =
            ExpectOwn(FieldsOf(*object), FieldsOfShapes(), p,
                      is_ball ? "a ball has none; boxes have" : "a box has none; balls have");
        if (!own.ok()) return own;
        Result<Done> set = SetFields(p, object);
        if (p.yes("never")) object->release_frame.reset();
        return set;
      });
}

Result<Done> RemoveHeld(Session* session, const Parameters& p) {
  return session->Edit("Remove held object", [&](Project* project) -> Result<Done> {
    auto& objects = project->held_objects;
    const Result<ProjectHeldObject*> object = EntryNamed(p.text("object"), "object", &objects);
    if (!object.ok()) return object.error();
    if (Result<Done> free = ExpectUnconstrained(p.text("object"), *project); !free.ok()) {
      return free;
    }
    std::erase_if(project->goals,
                  [&](const ProjectGoal& goal) { return goal.object == p.text("object"); });
    objects.erase(objects.begin() + (object.value() - objects.data()));
    return Done();
  });
}

}  // namespace

Mat3 TurnOf(const Vec3& rotation_deg) { return EulerRotation({2, 1, 0}, kDegree * rotation_deg); }

Vec3 InThePalm(const Figure& figure, GroupIndex holder, const ProjectHeldObject& object,
               const Vec3& rotation_deg) {
  const Mat3 R = TurnOf(rotation_deg);
  const double radius =
      std::visit([&](const auto& shape) { return RadiusOf(shape, R); }, object.shape);
  const JointIndex body = figure.group(holder).last();
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, {Mat3::Identity(), Vec3::Zero()}, VecX::Zero(figure.num_joints()), &ws);
  const double inward = ws.body(body).p.y() > 0.0 ? -1.0 : 1.0;  // of a left hand
  for (const Link& link : figure.links()) {
    if (link.joint != body) continue;
    return 0.5 * (link.capsule.a + link.capsule.b) + Vec3(0.0, inward * radius, 0.0);
  }
  return Vec3::Zero();
}

Result<GroupIndex> HolderGiven(const Session& session, const Parameters& p) {
  const std::string name = p.has("joint") ? p.text("joint") : FirstSelectedJoint(session);
  if (name.empty()) return Refusal("joint", "is missing, and no joint is selected");
  const auto group = session.figure().FindGroup(name);
  if (!group) return Refusal("joint", "there is no joint \"" + name + "\"");
  return *group;
}

// Frames in which somebody lets go of an object.
static std::set<int> ReleasesOf(const ProjectHeldObject& object, const Project& project) {
  std::set<int> frames;
  for (const HolderSpan& holder : HoldersOf(object, project.frames)) {
    if (holder.is_let_go) frames.insert(holder.last);
  }
  return frames;
}

// A goal of an object goes with the release that is moved.
static void FollowRelease(const ProjectHeldObject& before, const ProjectHeldObject& now,
                          Project* project) {
  const std::set<int> were = ReleasesOf(before, *project), are = ReleasesOf(now, *project);
  std::vector<int> gone, come;
  std::set_difference(were.begin(), were.end(), are.begin(), are.end(), std::back_inserter(gone));
  std::set_difference(are.begin(), are.end(), were.begin(), were.end(), std::back_inserter(come));
  if (gone.size() != 1 || come.size() != 1) return;
  for (ProjectGoal& goal : project->goals) {
    const bool is_its = goal.kind == GoalKind::kObject && goal.object == before.name;
    if (is_its && goal.frame == gone[0]) goal.frame = come[0];
  }
}

Result<Done> ChangeHeld(Session* session, const Parameters& p, const char* label,
                        const std::function<Result<Done>(ProjectHeldObject*)>& change) {
  return session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        auto& objects = project->held_objects;
        const Result<ProjectHeldObject*> object = EntryNamed(p.text("object"), "object", &objects);
        if (!object.ok()) return object.error();
        const ProjectHeldObject before = *object.value();
        Result<Done> done = change(object.value());
        FollowRelease(before, *object.value(), project);
        object.value()->name = FreeName(object.value()->name, objects, object.value());
        RenameObject(p.text("object"), object.value()->name, project);
        return done;
      },
      p.text("drag"));
}

std::vector<Operator> HeldObjectOperators() {
  return {
      {"held.add_ball", "Add ball",
       "Puts a ball into a hand. Not given: a baseball in the selected joint, beside its bone; if "
       "none "
       "is selected, on the ground.",
       FieldsOf(NewBall()), AddHeldBall},
      {"held.add_box", "Add held box",
       "Puts a box into a hand. Not given: 10 cm, in the selected joint, beside its bone; if none "
       "is "
       "selected, on the ground.",
       FieldsOf(NewBox()), AddHeldBox},
      {"file.add_mesh", "Add mesh",
       "Puts a thing with a mesh of another program into a hand: glTF, GLB, FBX, Collada or OBJ. "
       "As "
       "heavy as a baseball, solid as the box around it; if no joint is given or selected, on the "
       "ground.",
       Joined({{{"path", kText, true, "the file"}}, FieldsOf(NewBox())}), AddHeldMesh},
      {"held.set", "Change held object", "Sets what is given of a held object.",
       Joined({{kObject},
               FieldsOfShapes(),
               {{"never", kYesNo, false, "true: it is never let go"}, kDrag}}),
       SetHeld},
      {"held.remove", "Remove held object", "Takes a held object away.", {kObject}, RemoveHeld}};
}

}  // namespace hazumi::edit
