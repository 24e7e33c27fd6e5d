#pragma once

// The curves of a project by name: hinges by their own, the root's "root.x" to "root.angle_x", a
// held object's "held.ball.x" to "held.ball.z".

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/figure/figure.h"
#include "engine/project/project.h"

namespace hazumi {

// Names of the root's curves, by RootCurve: its origin [m] and the angles of R = Rz Ry Rx [deg].
inline constexpr const char* kRootCurveNames[kNumRootCurves] = {
    "root.x", "root.y", "root.z", "root.angle_z", "root.angle_y", "root.angle_x"};
std::optional<int> RootCurveNamed(const std::string& name);

// A curve of a held object's position [m].
struct ObjectCurve {
  size_t object;  // index of Project::held_objects
  int axis;       // x, y, z
};
// Returns nothing if the project has no such object.
std::optional<ObjectCurve> ObjectCurveNamed(const std::string& name, const Project& project);
std::string NameOfCurve(const ProjectHeldObject& object, int axis);
// Whether any curve of the object has keys: then all have.
bool HasKeys(const ProjectHeldObject& object);

// Returns the curve of a name. A hinge without one gets one. Errors: kSchema if the figure has no
// such hinge.
Result<ProjectCurve*> CurveNamed(const std::string& name, const Figure& figure, Project* project);
// Returns the curve of a name, or null.
const ProjectCurve* FindCurve(const std::string& name, const Project& project);
// Names of all curves that a project has: the root's, and those of hinges and objects with keys.
std::vector<std::string> CurveNames(const Project& project);
// Names of the curves of hinges; the root stands for its six.
std::vector<std::string> CurvesOf(const std::set<std::string>& joints, const Figure& figure);

}  // namespace hazumi
