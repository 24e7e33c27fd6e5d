// What an object of the scene looks like.

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// What is not given stays. Errors: no such object, or a size for a plane.
Result<Done> SetObject(Session* session, const Parameters& p) {
  return session->Edit(
      "Change object",
      [&](Project* project) -> Result<Done> {
        const Result<ProjectSceneObject*> object =
            EntryNamed(p.text("object"), "object", &project->scene.objects);
        if (!object.ok()) return object.error();
        object.value()->color = p.text("color", object.value()->color);
        auto* box = std::get_if<ProjectBox>(&object.value()->shape);
        const char* sizes[] = {"size_x", "size_y", "size_z"};
        for (int i = 0; i < 3; ++i) {
          if (!p.has(sizes[i])) continue;
          if (!box) return Refusal(sizes[i], "a plane has no size; boxes have");
          box->size_m[i] = p.number(sizes[i]);
        }
        return Done();
      },
      p.text("drag"));
}

}  // namespace

std::vector<Operator> ObjectOperators() {
  return {{"object.set",
           "Change object",
           "Sets the size and the colour of an object; what is not given stays.",
           {{"object", kText, true, "the object's name", Thing::kObject},
            {"size_x", kNumber, false, "length of a box's edges in metres"},
            {"size_y", kNumber, false, "metres"},
            {"size_z", kNumber, false, "metres"},
            {"color", kText, false, "#rrggbb", Thing::kColor},
            kDrag},
           SetObject}};
}

}  // namespace hazumi::edit
