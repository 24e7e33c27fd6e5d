#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// What something in the scene pushes a capsule with, where it touches it.
struct ContactPush {
  // As ContactCapsule and ContactObstacle say; -1: not known.
  int link = -1, object = -1;
  Vec3 p = Vec3::Zero();      // world [m]
  Vec3 force = Vec3::Zero();  // on the link [N]
  bool operator==(const ContactPush&) const = default;
};

}  // namespace hazumi
