#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// A force and its moment about a point, which whoever has it names.
struct Wrench {
  Vec3 force = Vec3::Zero();   // [N]
  Vec3 moment = Vec3::Zero();  // [N m]
};

}  // namespace hazumi
