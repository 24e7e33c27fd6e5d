#pragma once

#include <vector>

#include "tests/bench/peer_joints.h"
#include "tests/bench/simbody_tree.h"

namespace hazumi::bench {

// A figure on a root that does not move: one mobilizer a group, Pin, Universal, and Gimbal or Ball;
// the ground is the root's frame.
std::vector<SimbodyTree::Body> SimbodyBodies(const Figure& figure, Threes threes);

}  // namespace hazumi::bench
