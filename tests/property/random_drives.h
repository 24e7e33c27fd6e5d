#pragma once

#include "engine/timeline/animation.h"
#include "tests/support/random.h"

namespace hazumi::test {

// Whether a region moves the hinge: it has it, with friction above 0 and room between its limits.
bool IsFree(const Animation& animation, JointIndex j);

// Gives joints of the animation's regions, whose every hinge is free, torques over time, springs of
// all kinds or their keys, one in five nothing. Torques are what accelerates all beyond a hinge by
// 1 to 100 rad/s^2, springs have 0.3 to 30 Hz. Joints that follow keys get some, up to frame 30.
// Each region goes on moving something.
void AddRandomDrives(Random* random, Animation* animation);

}  // namespace hazumi::test
