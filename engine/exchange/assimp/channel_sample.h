#pragma once

#include <assimp/anim.h>

#include <Eigen/Geometry>
#include <optional>

#include "engine/spatial/types.h"

namespace hazumi {

// Whether the values of a channel stay until the next key.
struct ChannelSteps {
  bool translation = false, rotation = false, scale = false;
  double slack = 0.0;  // how much later [ticks] a time may be than it seems, for rounding
};

// A channel at a time [ticks]: linear between keys, along the sphere for rotations, constant before
// the first and after the last. Empty: it has no keys of this kind.
struct ChannelValue {
  std::optional<Vec3> translation, scale;
  std::optional<Eigen::Quaterniond> rotation;
};
ChannelValue SampleChannel(const aiNodeAnim& channel, const ChannelSteps& steps, double tick);

// Whether times increase (equal ones allowed) and all numbers are finite.
bool IsSoundChannel(const aiNodeAnim& channel);

}  // namespace hazumi
