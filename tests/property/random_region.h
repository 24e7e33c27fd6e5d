#pragma once

#include <cstddef>
#include <limits>

#include "engine/bake/bake.h"
#include "engine/figure/figure_spec.h"
#include "engine/timeline/animation.h"
#include "tests/support/random.h"

namespace hazumi::test {

// One in three is the human that is shipped, with its own limits.
FigureSpec RandomFigureSpec(bool has_limits, Random* random);
Figure RandomFigure(bool has_limits, Random* random);

// What a random region is made of, in this order. One or two joints, with all beyond them or by
// themselves: two arms at most.
void ChooseJoints(const Figure& figure, Random* random, DynamicsRegion* region);
// Equal or one by one, 0 in some joints.
void ChooseFriction(Random* random, DynamicsRegion* region);
// A pose, start rates of at most 15 rad/s, and curves up to frame 30 for joints outside the region.
void ChooseKeys(const DynamicsRegion& region, Random* random, Animation* animation);
// Keyed, pinned or in flight up to frame 30, and sometimes turning freely where it is not keyed.
void ChooseRoot(Random* random, DynamicsRegion* region, Animation* animation);

// An animation of a random figure with one exact region of 5 to 30 frames from frame 0 on, start
// rates of at most 15 rad/s, joints outside it moving by keys, friction of all kinds, the root
// keyed, pinned or in flight, and sometimes turning freely.
Animation RandomRegion(uint64_t seed, bool has_limits);

// The largest error of an angle of a region at any frame up to `until` [rad]: of a joint of three
// free hinges and of the root that of the orientation, of any other hinge that of its angle.
double LargestError(const Animation& animation, const Motion& motion, const Motion& reference,
                    size_t region = 0, double until = std::numeric_limits<double>::infinity());

}  // namespace hazumi::test
