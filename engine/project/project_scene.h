#pragma once

// What stands around the figure, what it holds and where it is seen from. Metres, kilograms and
// degrees; colours "#rrggbb" (sRGB).

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/item_id.h"
#include "engine/project/json/extra_fields.h"
#include "engine/spatial/types.h"

namespace hazumi {

inline constexpr const char* kDefaultObjectColor = "#808080";

// The half space where normal . x <= offset is solid.
struct ProjectPlane {
  Vec3 normal = Vec3::UnitZ();  // unit vector
  double offset_m = 0.0;
  ExtraFields extra;
  bool operator==(const ProjectPlane&) const = default;
};

struct ProjectBox {
  Vec3 center_m = Vec3::Zero();
  Vec3 size_m = Vec3::Ones();        // whole edges
  Vec3 rotation_deg = Vec3::Zero();  // angles z, y, x of R = Rz Ry Rx
  ExtraFields extra;
  bool operator==(const ProjectBox&) const = default;
};

struct ProjectSceneObject {
  std::string name;
  std::variant<ProjectPlane, ProjectBox> shape;
  std::string color = kDefaultObjectColor;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectSceneObject&) const = default;
};

struct ProjectScene {
  double gravity_m_s2 = 9.81;  // along -z
  std::vector<ProjectSceneObject> objects;
  ExtraFields extra;
  bool operator==(const ProjectScene&) const = default;
};

struct ProjectSphereShape {
  double radius_m = 0.0;
  ExtraFields extra;
  bool operator==(const ProjectSphereShape&) const = default;
};

struct ProjectBoxShape {
  Vec3 size_m = Vec3::Ones();  // whole edges, along the holder's axes
  ExtraFields extra;
  bool operator==(const ProjectBoxShape&) const = default;
};

struct ProjectHeldObject {
  std::string name;
  std::variant<ProjectSphereShape, ProjectBoxShape> shape;
  double mass_kg = 0.0;
  std::string joint;             // the holder
  Vec3 offset_m = Vec3::Zero();  // of the centre, in the holder's frame
  std::optional<int> release_frame;
  std::string color = kDefaultObjectColor;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectHeldObject&) const = default;
};

struct ProjectCamera {
  Vec3 eye_m = Vec3(0.0, -3.0, 1.0);
  Vec3 target_m = Vec3(0.0, 0.0, 1.0);
  double vertical_fov_deg = 35.0;
  ExtraFields extra;
  bool operator==(const ProjectCamera&) const = default;
};

}  // namespace hazumi
