#include "ui/edit/operators/held/object_curves.h"

namespace hazumi::edit {

std::string NameOfCurve(const ProjectHeldObject& object, int axis) {
  return "held." + object.name + "." + "xyz"[axis];
}

std::optional<ObjectCurve> ObjectCurveNamed(const std::string& name, const Project& project) {
  if (!name.starts_with("held.")) return std::nullopt;
  for (size_t i = 0; i < project.held_objects.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (NameOfCurve(project.held_objects[i], axis) == name) return ObjectCurve{i, axis};
    }
  }
  return std::nullopt;
}

bool HasKeys(const ProjectHeldObject& object) { return !object.position.curves[0].keys.empty(); }

}  // namespace hazumi::edit
