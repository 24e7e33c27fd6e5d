#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// What something in the scene, or another link, pushes a capsule with, where it touches it.
struct ContactPush {
  // As ContactCapsule and ContactObstacle say; -1: it is none.
  int link = -1, object = -1;
  int by_link = -1;           // that pushes
  Vec3 p = Vec3::Zero();      // world [m]
  Vec3 force = Vec3::Zero();  // on the link [N]
  bool operator==(const ContactPush&) const = default;
};

}  // namespace hazumi
