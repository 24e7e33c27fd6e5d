#pragma once

// What stands around the figure, what it holds and where it is seen from. Metres, kilograms and
// degrees; colours "#rrggbb" (sRGB).

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/item_id.h"
#include "engine/project/json/extra_fields.h"
#include "engine/project/project_curve.h"
#include "engine/project/project_figure.h"
#include "engine/spatial/types.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

inline constexpr const char* kDefaultObjectColor = "#808080";
inline constexpr double kDefaultFrictionCoefficient = SceneObject::kFriction;

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
  double friction_coefficient = kDefaultFrictionCoefficient;
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
  Vec3 size_m = Vec3::Ones();  // whole edges, along its own axes
  ExtraFields extra;
  bool operator==(const ProjectBoxShape&) const = default;
};

// Who takes an object over later.
struct ProjectHolder {
  std::string joint;
  Vec3 offset_m = Vec3::Zero();      // of the object's centre, in the joint's frame
  Vec3 rotation_deg = Vec3::Zero();  // of its axes there: angles z, y, x of R = Rz Ry Rx
  int first_frame = 0;
  std::optional<int> last_frame;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectHolder&) const = default;
};

// Of the centre, along the world's axes [m].
struct ProjectPosition {
  std::array<ProjectCurve, 3> curves;  // x, y, z
  ExtraFields extra;
  bool operator==(const ProjectPosition&) const = default;
};

struct ProjectHeldObject {
  std::string name;
  std::variant<ProjectSphereShape, ProjectBoxShape> shape;
  double mass_kg = 0.0;
  std::string joint;                 // the holder from the first frame on; empty: nobody
  Vec3 offset_m = Vec3::Zero();      // of the centre, in the holder's frame
  Vec3 rotation_deg = Vec3::Zero();  // of its axes there: angles z, y, x of R = Rz Ry Rx
  std::optional<int> release_frame;
  std::vector<ProjectHolder> holders;  // that follow
  ProjectPosition position;            // while nobody holds it
  bool contacts = false;               // let go, a ball stays out of planes and boxes
  double friction_coefficient = kDefaultFrictionCoefficient;
  double restitution = 0.0;
  ProjectMesh mesh;  // drawn in place of the shape
  std::string color = kDefaultObjectColor;
  ExtraFields extra;
  Identity identity = {};
  bool operator==(const ProjectHeldObject&) const = default;
};

// True if more is said of it than who has it from the first frame on, and until when.
inline bool ChangesHands(const ProjectHeldObject& object) {
  return object.joint.empty() || !object.holders.empty() || object.position != ProjectPosition();
}

struct ProjectCamera {
  Vec3 eye_m = Vec3(0.0, -3.0, 1.0);
  Vec3 target_m = Vec3(0.0, 0.0, 1.0);
  double vertical_fov_deg = 35.0;
  ExtraFields extra;
  bool operator==(const ProjectCamera&) const = default;
};

// A sound file that is heard with the motion. Nothing moves by it.
struct ProjectAudio {
  std::string file;     // as written, relative to the project's folder
  int start_frame = 0;  // on which it begins; may lie outside the project's frames
  double gain_db = 0.0;
  bool mute = false;
  ExtraFields extra;
  bool operator==(const ProjectAudio&) const = default;
};

enum class ReferenceView { kBackground, kPlane };

// A picture or a video to animate by. Nothing moves by it.
struct ProjectReference {
  std::string file;     // as written, relative to the project's folder
  int start_frame = 0;  // on which a video begins
  ReferenceView view = ReferenceView::kBackground;
  Vec3 center_m = Vec3(0.0, 0.0, 1.0);  // of a plane
  double turn_deg = 0.0;                // of a plane, about the vertical; 0: it looks along -y
  double height_m = 2.0;                // of a plane
  double opacity = 0.5;
  bool mute = false;
  bool rendered = false;  // also in rendered pictures
  ExtraFields extra;
  bool operator==(const ProjectReference&) const = default;
};

}  // namespace hazumi
