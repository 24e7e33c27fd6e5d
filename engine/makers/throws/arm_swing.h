#pragma once

// Internal. The swing of an arm that throws, from its wind-up to where it lets go: the motion of
// least torque that arrives with the angles and rates of a release.

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/makers/aims/aim_goals.h"
#include "engine/makers/throws/throw_path.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

struct ArmSwing {
  std::vector<JointIndex> hinges;
  std::vector<int> frames;  // from the wind-up to the release
  MatX angles, rates;       // hinges x frames: a cubic between two of them each [rad, rad/s]
  ThrowPath path;           // of what it lets go
  double muscle = 0.0;      // largest torque as a share of what the hinge can give
};

// `arm`: the hinges that swing, from the frame of the wind-up on; `motion`: of the animation up to
// the goal's frame, with the arm anyhow. Errors: kSemantics, with the distance missed.
Result<ArmSwing> SwingArm(const AimGoal& goal, const DynamicsRegion& arm,
                          const Animation& animation, const Motion& motion);

}  // namespace hazumi::makers
