// Objects that joints hold until they let go.

#include <algorithm>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

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
  return object;
}
// As large and as heavy as a baseball.
ProjectHeldObject NewBall() { return NewObject(ProjectSphereShape{0.037, {}}, "ball"); }
ProjectHeldObject NewBox() { return NewObject(ProjectBoxShape{Vec3(0.1, 0.1, 0.1), {}}, "box"); }

// Of balls and boxes.
ParameterInfos FieldsOfShapes() {
  return Joined({FieldsOf(NewBall()), Only({"size_x", "size_y", "size_z"}, FieldsOf(NewBox()))});
}

// From a holder's bones to the centre of what lies at its surface.
double RadiusOf(const ProjectSphereShape& sphere) { return sphere.radius_m; }
double RadiusOf(const ProjectBoxShape& box) { return 0.5 * box.size_m.y(); }

// Half way along the holder's first link, on the side of its y axis: in the palm of the shipped
// human's hands.
Vec3 PlaceIn(const Figure& figure, GroupIndex holder, double radius) {
  const JointIndex body = figure.group(holder).last();
  for (const Link& link : figure.links()) {
    if (link.joint != body) continue;
    return 0.5 * (link.capsule.a + link.capsule.b) + Vec3(0.0, radius, 0.0);
  }
  return Vec3::Zero();
}

bool IsOffsetGiven(const Parameters& p) {
  return p.has("offset_x") || p.has("offset_y") || p.has("offset_z");
}

// By the parameter "joint"; not given: the first selected joint.
Result<GroupIndex> Holder(const Session& session, const Parameters& p) {
  const Figure& figure = session.figure();
  std::string name = p.text("joint");
  for (const Joint& hinge : figure.joints()) {
    if (p.has("joint") || !name.empty()) break;
    if (session.selected_joints().contains(hinge.name)) name = figure.group(hinge.group).name;
  }
  if (name.empty()) return Refusal("joint", "is missing, and no joint is selected");
  const auto group = figure.FindGroup(name);
  if (!group) return Refusal("joint", "there is no joint \"" + name + "\"");
  return *group;
}

Result<Done> AddHeld(Session* session, const Parameters& p, ProjectHeldObject object) {
  const Result<GroupIndex> holder = Holder(*session, p);
  if (!holder.ok()) return holder.error();
  return session->Edit("Add held object", [&](Project* project) -> Result<Done> {
    if (Result<Done> set = SetFields(p, &object); !set.ok()) return set;
    object.name = FreeName(object.name, project->held_objects);
    object.joint = session->figure().group(holder.value()).name;
    if (!IsOffsetGiven(p)) {
      const double radius =
          std::visit([](const auto& shape) { return RadiusOf(shape); }, object.shape);
      object.offset_m = PlaceIn(session->figure(), holder.value(), radius);
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

// Runs on one object by its name.
template <typename Action>
Result<Done> ChangeHeld(Session* session, const Parameters& p, const char* label, Action action) {
  return session->Edit(
      label,
      [&](Project* project) -> Result<Done> {
        auto& objects = project->held_objects;
        const Result<ProjectHeldObject*> object = EntryNamed(p.text("object"), "object", &objects);
        if (!object.ok()) return object.error();
        return action(&objects, object.value());
      },
      p.text("drag"));
}

using Objects = std::vector<ProjectHeldObject>;

Result<Done> SetHeld(Session* session, const Parameters& p) {
  return ChangeHeld(
      session, p, "Change held object", [&](Objects* objects, ProjectHeldObject* object) {
        const bool is_ball = std::holds_alternative<ProjectSphereShape>(object->shape);
        Result<Done> own =
            ExpectOwn(FieldsOf(*object), FieldsOfShapes(), p,
                      is_ball ? "a ball has none; boxes have" : "a box has none; balls have");
        if (!own.ok()) return own;
        Result<Done> set = SetFields(p, object);
        if (p.yes("never")) object->release_frame.reset();
        if (p.has("name")) object->name = FreeName(object->name, *objects, object);
        return set;
      });
}

Result<Done> RemoveHeld(Session* session, const Parameters& p) {
  return ChangeHeld(session, p, "Remove held object",
                    [&](Objects* objects, ProjectHeldObject* object) {
                      objects->erase(objects->begin() + (object - objects->data()));
                      return Result<Done>(Done());
                    });
}

}  // namespace

std::vector<Operator> HeldObjectOperators() {
  return {
      {"held.add_ball", "Add ball",
       "Puts a ball into a hand. Not given: a baseball in the selected joint, beside its bone.",
       FieldsOf(NewBall()), AddHeldBall},
      {"held.add_box", "Add held box",
       "Puts a box into a hand. Not given: 10 cm, in the selected joint, beside its bone.",
       FieldsOf(NewBox()), AddHeldBox},
      {"held.set", "Change held object", "Sets what is given of a held object.",
       Joined({{kObject},
               FieldsOfShapes(),
               {{"never", kYesNo, false, "true: it is never let go"}, kDrag}}),
       SetHeld},
      {"held.remove", "Remove held object", "Takes a held object away.", {kObject}, RemoveHeld}};
}

}  // namespace hazumi::edit
