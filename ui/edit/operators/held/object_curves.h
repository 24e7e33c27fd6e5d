#pragma once

// The curves of a held object's position: "held.ball.x" to "held.ball.z" [m].

#include <optional>
#include <string>

#include "engine/project/project.h"

namespace hazumi::edit {

struct ObjectCurve {
  size_t object;  // index of Project::held_objects
  int axis;       // x, y, z
};
// None if the project has no such object.
std::optional<ObjectCurve> ObjectCurveNamed(const std::string& name, const Project& project);
std::string NameOfCurve(const ProjectHeldObject& object, int axis);
// Whether any of its curves has keys: then all have.
bool HasKeys(const ProjectHeldObject& object);

}  // namespace hazumi::edit
