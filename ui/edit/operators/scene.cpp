// The scene and the solver.

#include <algorithm>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kObject = {"object", kText, true, "the object's name", Thing::kObject};

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

Result<Done> AddPlane(Session* session, const Parameters& p) {
  const Vec3 normal(p.number("normal_x"), p.number("normal_y"), p.number("normal_z"));
  const bool is_given = p.has("normal_x") || p.has("normal_y") || p.has("normal_z");
  if (is_given && normal.norm() < 1e-9) {
    return Refusal("normal_x", "the normal must not be zero: it gives a direction");
  }
  return session->Edit("Add plane", [&](Project* project) -> Result<Done> {
    ProjectPlane plane;
    if (is_given) plane.normal = normal.normalized();
    plane.offset_m = p.number("offset");
    project->scene.objects.push_back(
        {p.text("name"), plane, p.text("color", kDefaultObjectColor), {}});
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
  return session->Edit(
      "Change solver",
      [&](Project* project) -> Result<Done> {
        if (p.has("method")) {
          const Result<Method> method = ValueNamed<Method>(
              p.text("method"), "method", {Method::kPaper, Method::kExact}, &NameOf);
          if (!method.ok()) return method.error();
          project->solver.method = method.value();
        }
        if (p.has("tolerance")) project->solver.tolerance_deg = p.number("tolerance");
        if (p.has("step")) project->solver.step_s = p.number("step");
        return Done();
      },
      p.text("drag"));
}

// Of a project without a camera the rest is as ProjectCamera begins.
Result<Done> SetCamera(Session* session, const Parameters& p) {
  return session->Edit(
      "Set camera",
      [&](Project* project) -> Result<Done> {
        ProjectCamera camera = project->camera.value_or(ProjectCamera());
        camera.eye_m = {p.number("eye_x", camera.eye_m.x()), p.number("eye_y", camera.eye_m.y()),
                        p.number("eye_z", camera.eye_m.z())};
        camera.target_m = {p.number("target_x", camera.target_m.x()),
                           p.number("target_y", camera.target_m.y()),
                           p.number("target_z", camera.target_m.z())};
        camera.vertical_fov_deg = p.number("fov", camera.vertical_fov_deg);
        project->camera = std::move(camera);
        return Done();
      },
      p.text("drag"));
}

Result<Done> SetGravity(Session* session, const Parameters& p) {
  return session->Edit(
      "Change gravity",
      [&](Project* project) -> Result<Done> {
        project->scene.gravity_m_s2 = p.number("gravity");
        return Done();
      },
      p.text("drag"));
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
            {"color", kText, false, "#rrggbb", Thing::kColor}},
           AddBox},
          {"object.add_plane",
           "Add plane",
           "Puts a plane into the scene; one side of it is solid.",
           {{"name", kText, true, "its name"},
            {"normal_x", kNumber, false, "out of the solid side; not given: upwards"},
            {"normal_y", kNumber, false, "of the normal, whose length does not matter"},
            {"normal_z", kNumber, false, "of the normal"},
            {"offset", kNumber, false, "from the origin along the normal in metres"},
            {"color", kText, false, "#rrggbb", Thing::kColor}},
           AddPlane},
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
           {{"method", kText, false, "exact or paper", "exact paper"},
            {"tolerance", kNumber, false, "of exact, in degrees"},
            {"step", kNumber, false, "of paper, in seconds"},
            kDrag},
           SetSolver},
          {"camera.set",
           "Set camera",
           "Sets where the animation is seen from; what is not given stays.",
           {{"eye_x", kNumber, false, "where it stands, metres"},
            {"eye_y", kNumber, false, "metres"},
            {"eye_z", kNumber, false, "metres"},
            {"target_x", kNumber, false, "what it looks at, metres"},
            {"target_y", kNumber, false, "metres"},
            {"target_z", kNumber, false, "metres"},
            {"fov", kNumber, false, "vertical field of view in degrees"},
            kDrag},
           SetCamera},
          {"scene.gravity",
           "Change gravity",
           "Sets the gravity.",
           {{"gravity", kNumber, true, "m/s2, downwards"}, kDrag},
           SetGravity}};
}

}  // namespace hazumi::edit
