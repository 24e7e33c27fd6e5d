#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/collision/shapes.h"
#include "engine/figure/indices.h"
#include "engine/figure/skin.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

// Returns the coefficient of friction between surfaces with the coefficients a and b: sqrt(a b).
inline double MixFriction(double a, double b) { return std::sqrt(a * b); }

// Something that stands in the world and can be touched.
struct SceneObject {
  std::string name;
  Obstacle shape;                           // world frame [m]
  std::string color;                        // "#rrggbb", sRGB
  double friction = kFriction;              // coefficient
  static constexpr double kFriction = 0.8;  // of figures, too
  bool operator==(const SceneObject&) const = default;
};

struct SphereShape {
  double radius = 0.0;  // [m]
  bool operator==(const SphereShape&) const = default;
};
struct BoxShape {
  Vec3 half_size = Vec3::Zero();  // [m], along its own axes
  bool operator==(const BoxShape&) const = default;
};

// A joint to whose body an object is fixed from the first frame to the last.
struct Holder {
  GroupIndex joint;
  Vec3 offset = Vec3::Zero();  // of the object's centre, in the joint's frame [m]
  static constexpr int kFromTheStart = std::numeric_limits<int>::min();
  int first_frame = kFromTheStart;
  std::optional<int> last_frame = {};  // the object is let go there; none: never
  Mat3 rotation = Mat3::Identity();    // of the object's axes, in the joint's frame
  bool operator==(const Holder&) const = default;
};

// What joints hold, one after the other. Let go, it flies on a parabola, turning as it did, until
// the next one has it or, at the latest, to its first key from then on: there it is where its keys
// say, along the world's axes. So it is before anyone holds it.
struct HeldObject {
  std::string name;
  std::variant<SphereShape, BoxShape> shape;
  double mass = 0.0;            // [kg], part of the holder's body while held
  std::vector<Holder> holders;  // ascending, disjoint
  std::array<Keys, 3> keys;     // of its centre in the world [m]; all have keys, or none
  std::string color;            // "#rrggbb", sRGB
  // Let go, it stays out of planes and boxes; a sphere only.
  bool touches_scene = false;
  double friction = SceneObject::kFriction;  // coefficient
  double restitution = 0.0;                  // Poisson's, 0 to 1
  std::shared_ptr<const Skin> mesh = {};  // drawn in the box around the shape; null: the shape is
  bool operator==(const HeldObject&) const = default;
};

// Whole edges of the box around a held object's shape, along its own axes [m].
Vec3 BoxAround(const HeldObject& object);

// Meshes about the middle of the box around them, which becomes one of this size; a side without
// length stays so. All binds are to the thing's own frame.
Skin Stretched(const Skin& mesh, const Vec3& size);

}  // namespace hazumi
