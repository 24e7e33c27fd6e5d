#pragma once

#include <algorithm>

#include "engine/bake/motion.h"
#include "engine/bake/walk/own_pairs.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi::test {

// How deep links are inside each other that may be told to stay out of each other [m]; not at all:
// 0.
inline double OwnDepth(const Figure& figure, const MotionFrame& frame) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  double depth = 0.0;
  for (const LinkPair& pair : PairsApart(figure)) {
    const Capsule a = hazumi::InWorld(figure.links()[pair.a], ws);
    const Capsule b = hazumi::InWorld(figure.links()[pair.b], ws);
    depth = std::max(depth, -SignedDistance(a, b).value);
  }
  return depth;
}

}  // namespace hazumi::test
