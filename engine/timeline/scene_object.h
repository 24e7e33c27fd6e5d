#pragma once

#include <optional>
#include <string>
#include <variant>

#include "engine/collision/shapes.h"
#include "engine/figure/indices.h"

namespace hazumi {

// Something that stands in the world and can be touched.
struct SceneObject {
  std::string name;
  Obstacle shape;     // world frame [m]
  std::string color;  // "#rrggbb", sRGB
  bool operator==(const SceneObject&) const = default;
};

struct SphereShape {
  double radius = 0.0;  // [m]
  bool operator==(const SphereShape&) const = default;
};
struct BoxShape {
  Vec3 half_size = Vec3::Zero();  // [m], along the holder's axes
  bool operator==(const BoxShape&) const = default;
};

// Fixed to the body of a joint until it is let go; then it flies on a parabola, turning as it did.
struct HeldObject {
  std::string name;
  std::variant<SphereShape, BoxShape> shape;
  double mass = 0.0;  // [kg], part of the holder's body while held
  GroupIndex holder;
  Vec3 offset = Vec3::Zero();        // its centre in the holder's frame [m]
  std::optional<int> release_frame;  // none: never let go
  std::string color;                 // "#rrggbb", sRGB
  bool operator==(const HeldObject&) const = default;
};

}  // namespace hazumi
