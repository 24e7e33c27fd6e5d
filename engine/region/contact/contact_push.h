#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// Who touches, as ContactCapsule and ContactObstacle say; -1: none.
struct ContactParts {
  int link = -1, object = -1;
  int by_link = -1, by_ball = -1;  // in place of an object of the scene; a ball is held otherwise
  bool operator==(const ContactParts&) const = default;

  // The other way round, of two links.
  ContactParts Swapped() const { return {by_link, -1, link}; }
};

// What something in the scene, another link or a ball pushes a link with, where it touches it.
struct ContactPush : ContactParts {
  Vec3 p = Vec3::Zero();      // world [m]
  Vec3 force = Vec3::Zero();  // on the link [N]
  bool operator==(const ContactPush&) const = default;
};

}  // namespace hazumi
