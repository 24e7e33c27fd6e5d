// The scene and the solver.

#include <algorithm>

#include "ui/edit/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kObject = {"object", kText, true, "the object's name"};

Result<Done> AddBox(Session* session, const Parameters& p) {
  return session->Edit("Add box", [&](Project* project) -> Result<Done> {
    ProjectBox box;
    box.center_m = {p.number("x"), p.number("y"), p.number("z")};
    box.size_m = {p.number("size_x", 1.0), p.number("size_y", 1.0), p.number("size_z", 1.0)};
    project->scene.objects.push_back(
        {p.text("name"), box, p.text("color", kDefaultObjectColor), {}});
    return Done();
  });
}

// A box, or how high a plane is.
Result<Done> MoveObject(Session* session, const Parameters& p) {
  return session->Edit(
      "Move object",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectSceneObject*> object =
            EntryNamed(p.text("object"), "object", &project->scene.objects);
        if (!object.ok()) return object.error();
        const Vec3 by(p.number("x"), p.number("y"), p.number("z"));
        if (auto* box = std::get_if<ProjectBox>(&object.value()->shape)) box->center_m += by;
        if (auto* plane = std::get_if<ProjectPlane>(&object.value()->shape)) {
          plane->offset_m += plane->normal.dot(by);
        }
        return Done();
      },
      p.text("drag"));
}

Result<Done> RemoveObject(Session* session, const Parameters& p) {
  return session->Edit("Remove object", [&](Project* project) -> Result<Done> {
    auto& objects = project->scene.objects;
    const Result<ProjectSceneObject*> object = EntryNamed(p.text("object"), "object", &objects);
    if (!object.ok()) return object.error();
    objects.erase(objects.begin() + (object.value() - objects.data()));
    return Done();
  });
}

Result<Done> SetSolver(Session* session, const Parameters& p) {
  return session->Edit("Change solver", [&](Project* project) -> Result<Done> {
    if (p.has("method")) {
      const Result<Method> method =
          ValueNamed<Method>(p.text("method"), "method", {Method::kPaper, Method::kExact}, &NameOf);
      if (!method.ok()) return method.error();
      project->solver.method = method.value();
    }
    if (p.has("tolerance")) project->solver.tolerance_deg = p.number("tolerance");
    if (p.has("step")) project->solver.step_s = p.number("step");
    return Done();
  });
}

Result<Done> SetGravity(Session* session, const Parameters& p) {
  return session->Edit("Change gravity", [&](Project* project) -> Result<Done> {
    project->scene.gravity_m_s2 = p.number("gravity");
    return Done();
  });
}

}  // namespace

std::vector<Operator> SceneOperators() {
  return {{"object.add_box",
           "Add box",
           "Puts a box into the scene.",
           {{"name", kText, true, "its name"},
            {"x", kNumber, false, "of its centre in metres"},
            {"y", kNumber, false, "of its centre"},
            {"z", kNumber, false, "of its centre"},
            {"size_x", kNumber, false, "length of its edges in metres"},
            {"size_y", kNumber, false, "length of its edges"},
            {"size_z", kNumber, false, "length of its edges"},
            {"color", kText, false, "#rrggbb"}},
           AddBox},
          {"object.move",
           "Move object",
           "Moves an object of the scene.",
           {kObject,
            {"x", kNumber, false, "metres"},
            {"y", kNumber, false, "metres"},
            {"z", kNumber, false, "metres"},
            kDrag},
           MoveObject},
          {"object.remove", "Remove object", "Takes an object away.", {kObject}, RemoveObject},
          {"solver.set",
           "Change solver",
           "Sets what regions use that say nothing themselves.",
           {{"method", kText, false, "exact or paper"},
            {"tolerance", kNumber, false, "of exact, in degrees"},
            {"step", kNumber, false, "of paper, in seconds"}},
           SetSolver},
          {"scene.gravity",
           "Change gravity",
           "Sets the gravity.",
           {{"gravity", kNumber, true, "m/s2, downwards"}},
           SetGravity}};
}

}  // namespace hazumi::edit
