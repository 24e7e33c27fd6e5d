// Objects of the scene.

#include <algorithm>
#include <cmath>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/objects.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kObject = {"object", kText, true, "the object's name", Thing::kObject};

const ParameterInfos kOffset = {{"x", kNumber, false, "metres"},
                                {"y", kNumber, false, "metres"},
                                {"z", kNumber, false, "metres"}};

template <typename Shape>
ProjectSceneObject NewObject(Shape shape) {
  ProjectSceneObject object;
  object.shape = std::move(shape);
  return object;
}

// Of planes and boxes.
ParameterInfos FieldsOfShapes() {
  ParameterInfos all = FieldsOf(NewObject(ProjectBox()));
  for (const ParameterInfo& info : FieldsOf(NewObject(ProjectPlane()))) {
    const auto is_it = [&](const ParameterInfo& other) {
      return std::string(other.name) == info.name;
    };
    if (std::none_of(all.begin(), all.end(), is_it)) all.push_back(info);
  }
  return all;
}

// The length of what is given as a plane's normal does not matter.
Result<Done> WithUnitNormal(ProjectSceneObject* object) {
  auto* plane = std::get_if<ProjectPlane>(&object->shape);
  if (!plane) return Done();
  if (plane->normal.norm() < 1e-9) {
    return Refusal("normal_x", "the normal must not be zero: it gives a direction");
  }
  if (std::abs(plane->normal.norm() - 1.0) > 1e-12) plane->normal.normalize();
  return Done();
}

Result<Done> ExpectOwn(const Parameters& p, const ProjectSceneObject& object) {
  const bool is_box = std::holds_alternative<ProjectBox>(object.shape);
  return ExpectOwn(FieldsOf(object), FieldsOfShapes(), p,
                   is_box ? "a box has none; planes have" : "a plane has none; boxes have");
}

// Of a box; 0 of a plane.
double HeightOf(const ProjectSceneObject& object) {
  const auto* box = std::get_if<ProjectBox>(&object.shape);
  return box ? box->size_m.z() : 0.0;
}

// A box that is made higher or lower keeps its base, unless it is said where its middle is.
void KeepBase(const Parameters& p, double higher, ProjectSceneObject* object) {
  auto* box = std::get_if<ProjectBox>(&object->shape);
  if (!box || p.has("x") || p.has("y") || p.has("z")) return;
  for (const char* angle : {"angle_x", "angle_y", "angle_z"}) {
    if (p.has(angle)) return;
  }
  box->center_m += TurnOf(box->rotation_deg) * Vec3(0.0, 0.0, 0.5 * higher);
}

// What is not given stays. A normal is brought to length 1.
Result<Done> SetObject(Session* session, const Parameters& p) {
  return session->Edit(
      "Change object",
      [&](Project* project) -> Result<Done> {
        auto& objects = project->scene.objects;
        const Result<ProjectSceneObject*> object = EntryNamed(p.text("object"), "object", &objects);
        if (!object.ok()) return object.error();
        if (Result<Done> own = ExpectOwn(p, *object.value()); !own.ok()) return own;
        const double high = HeightOf(*object.value());
        if (Result<Done> set = SetFields(p, object.value()); !set.ok()) return set;
        KeepBase(p, HeightOf(*object.value()) - high, object.value());
        if (p.has("name")) {
          object.value()->name = FreeName(object.value()->name, objects, object.value());
          RenameObject(p.text("object"), object.value()->name, project);
        }
        return WithUnitNormal(object.value());
      },
      p.text("drag"));
}

Result<Done> AddBox(Session* session, const Parameters& p) {
  return session->Edit(
      "Add box",
      [&](Project* project) -> Result<Done> {
        ProjectSceneObject object = NewObject(ProjectBox());
        if (Result<Done> set = SetFields(p, &object); !set.ok()) return set;
        project->scene.objects.push_back(std::move(object));
        return Done();
      },
      p.text("drag"));
}

Result<Done> AddPlane(Session* session, const Parameters& p) {
  return session->Edit("Add plane", [&](Project* project) -> Result<Done> {
    ProjectSceneObject object;
    auto& plane = std::get<ProjectPlane>(object.shape);
    if (p.has("normal_x") || p.has("normal_y") || p.has("normal_z")) plane.normal.setZero();
    if (Result<Done> set = SetFields(p, &object); !set.ok()) return set;
    if (Result<Done> unit = WithUnitNormal(&object); !unit.ok()) return unit;
    project->scene.objects.push_back(std::move(object));
    return Done();
  });
}

Vec3 OffsetOf(const Parameters& p) { return {p.number("x"), p.number("y"), p.number("z")}; }

// A box, or how high a plane is.
void MoveBy(const Vec3& by, ProjectSceneObject* object) {
  if (auto* box = std::get_if<ProjectBox>(&object->shape)) box->center_m += by;
  if (auto* plane = std::get_if<ProjectPlane>(&object->shape)) {
    plane->offset_m += plane->normal.dot(by);
  }
}

Result<Done> MoveObject(Session* session, const Parameters& p) {
  return session->Edit(
      "Move object",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectSceneObject*> object =
            EntryNamed(p.text("object"), "object", &project->scene.objects);
        if (!object.ok()) return object.error();
        MoveBy(OffsetOf(p), object.value());
        return Done();
      },
      p.text("drag"));
}

Result<Done> DuplicateObject(Session* session, const Parameters& p) {
  return session->Edit(
      "Duplicate object",
      [&](Project* project) -> Result<Done> {
        auto& objects = project->scene.objects;
        const Result<ProjectSceneObject*> object = EntryNamed(p.text("object"), "object", &objects);
        if (!object.ok()) return object.error();
        ProjectSceneObject copy = *object.value();
        copy.name = FreeObjectName(copy.name, *project);
        copy.identity = {};
        MoveBy(OffsetOf(p), &copy);
        objects.push_back(std::move(copy));
        return Done();
      },
      p.text("drag"));
}

Result<Done> RemoveObject(Session* session, const Parameters& p) {
  return session->Edit("Remove object", [&](Project* project) -> Result<Done> {
    auto& objects = project->scene.objects;
    const Result<ProjectSceneObject*> object = EntryNamed(p.text("object"), "object", &objects);
    if (!object.ok()) return object.error();
    if (Result<Done> free = ExpectUnconstrained(p.text("object"), *project); !free.ok()) {
      return free;
    }
    objects.erase(objects.begin() + (object.value() - objects.data()));
    return Done();
  });
}

}  // namespace

std::vector<Operator> ObjectOperators() {
  return {
      {"object.add_box", "Add box", "Puts a box into the scene.",
       Joined({Requiring({"name"}, FieldsOf(NewObject(ProjectBox()))), {kDrag}}), AddBox},
      {"object.add_plane", "Add plane", "Puts a plane into the scene; one side of it is solid.",
       Requiring({"name"}, FieldsOf(NewObject(ProjectPlane()))), AddPlane},
      {"object.set", "Change object",
       "Sets what is given of an object; what is not given stays. A box that is made higher keeps "
       "its base.",
       Joined({{kObject}, FieldsOfShapes(), {kDrag}}), SetObject},
      {"object.move", "Move object", "Moves an object of the scene.",
       Joined({{kObject}, kOffset, {kDrag}}), MoveObject},
      {"object.duplicate", "Duplicate object",
       "Puts another box or plane like this one into the scene, so far from it.",
       Joined({{kObject}, kOffset, {kDrag}}), DuplicateObject},
      {"object.remove", "Remove object", "Takes an object away.", {kObject}, RemoveObject}};
}

}  // namespace hazumi::edit
