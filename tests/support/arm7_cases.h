#pragma once

// Passive swings of Arm7() with known results. Angles in degrees, as they were published; rates in
// rad/s; base fixed, gravity 9.81 m/s^2 down, ten frames of 1/30 s.

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi::test {

using Vec7 = Eigen::Matrix<double, 7, 1>;

struct PaperResult {
  int steps_per_frame;
  Vec7 end_deg;
};

struct ArmCase {
  const char* name;
  Vec7 start_deg, start_rate;
  Vec7 friction;  // factor per 1/30 s
  Vec7 lower_deg, upper_deg;
  Vec7 bias, free_acceleration;      // at the start [N m, rad/s^2]
  std::vector<PaperResult> results;  // of the paper's step, friction f^(1/N) at N steps a frame
  Vec7 converged_deg;                // in the limit of small steps
};

constexpr int kArmCaseFrames = 10;
constexpr double kArmCaseGravity = 9.81;

ArmCase SwingWithLimits();  // friction 0.8 and 0.4; elbow flexion and elbow turn reach their limits
ArmCase FreeSwing();        // no friction, no limits
ArmCase NearGimbal();       // FreeSwing starting 2 degrees from the shoulder's singular pose

}  // namespace hazumi::test
