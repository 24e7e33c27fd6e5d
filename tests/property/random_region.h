#pragma once

#include "engine/bake/bake.h"
#include "engine/timeline/animation.h"
#include "tests/support/random.h"

namespace hazumi::test {

// One in three is the human that is shipped, with its own limits.
Figure RandomFigure(bool has_limits, Random* random);

// An animation of a random figure with one exact region of 5 to 30 frames from frame 0 on, start
// rates of at most 15 rad/s, joints outside it moving by keys, friction of all kinds, the root
// keyed, pinned or in flight, and sometimes turning freely.
Animation RandomRegion(uint64_t seed, bool has_limits);

// The largest error of an angle of the region at any frame [rad]: of a joint of three free hinges
// and of the root that of the orientation, of any other hinge that of its angle.
double LargestError(const Animation& animation, const Motion& motion, const Motion& reference);

}  // namespace hazumi::test
