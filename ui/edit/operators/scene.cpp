// The scene and the solver.

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

Result<Done> SetSolver(Session* session, const Parameters& p) {
  return session->Edit(
      "Change solver",
      [&](Project* project) -> Result<Done> { return SetFields(p, &project->solver); },
      p.text("drag"));
}

// Of a project without a camera the rest is as ProjectCamera begins.
Result<Done> SetCamera(Session* session, const Parameters& p) {
  return session->Edit(
      "Set camera",
      [&](Project* project) -> Result<Done> {
        ProjectCamera camera = project->camera.value_or(ProjectCamera());
        if (Result<Done> set = SetFields(p, &camera); !set.ok()) return set;
        project->camera = std::move(camera);
        return Done();
      },
      p.text("drag"));
}

Result<Done> SetGravity(Session* session, const Parameters& p) {
  return session->Edit(
      "Change gravity",
      [&](Project* project) -> Result<Done> { return SetFields(p, &project->scene); },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> SceneOperators() {
  return {{"solver.set", "Change solver", "Sets what regions use that say nothing themselves.",
           Joined({FieldsOf<ProjectSolver>(), {kDrag}}), SetSolver},
          {"camera.set", "Set camera",
           "Sets where the animation is seen from; what is not given stays.",
           Joined({FieldsOf<ProjectCamera>(), {kDrag}}), SetCamera},
          {"scene.gravity", "Change gravity", "Sets the gravity.",
           Joined({Requiring({"gravity"}, FieldsOf<ProjectScene>()), {kDrag}}), SetGravity}};
}

}  // namespace hazumi::edit
