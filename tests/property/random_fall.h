#pragma once

#include <cstdint>

#include "engine/timeline/animation.h"

namespace hazumi::test {

enum class Terrain { kPlane, kBoxes, kStairs };

// A random figure in a random pose, let go a little above a plane, boxes or stairs, which may turn
// and drift as it falls: five seconds at 30 frames each, friction 0.8 in all joints, coefficients
// of friction of 0.4 to 0.9.
Animation RandomFall(uint64_t seed, Terrain terrain);

// Lets some balls, of up to as much as a few kilograms, fall onto it.
void DropBalls(uint64_t seed, Animation* animation);

}  // namespace hazumi::test
