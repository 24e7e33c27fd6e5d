#include "engine/bake/walk/spring_of.h"

#include <algorithm>
#include <numbers>

#include "engine/passive/ball_axes.h"

namespace hazumi {

namespace {

// What the hinges of a ball joint can give at rest, along the ball's axes: its first two are those
// of the first two hinges, and the third hinge lies along its third or against it.
void LimitBall(const Figure& figure, const JointGroup& group, const BallAxes& ball, double share,
               Spring* spring) {
  for (int i = 0; i < 3; ++i) {
    const Joint& hinge = figure.joints()[group.first.value() + i];
    if (!hinge.strength) continue;
    const StrengthLimits limits = hinge.strength->At(hinge.rest, 0.0);
    const bool is_against = i == 2 && ball.is_third_against;
    (is_against ? spring->most_backward : spring->most_forward)[i] = share * limits.positive.torque;
    (is_against ? spring->most_forward : spring->most_backward)[i] = share * limits.negative.torque;
  }
}

void LimitByMuscles(const Figure& figure, JointIndex joint, double share, Spring* spring) {
  spring->muscles = figure.joint(joint).strength;
  spring->share = share;
  const JointGroup& group = figure.group(figure.joint(joint).group);
  if (const auto ball = BallAxesOf(figure, group)) LimitBall(figure, group, *ball, share, spring);
}

}  // namespace

Spring SpringOf(const Drive& drive, JointIndex joint, const DynamicsRegion& region,
                const Figure& figure, const RegionStart& start) {
  const auto found = std::lower_bound(region.joints.begin(), region.joints.end(), joint);
  const auto i = static_cast<size_t>(found - region.joints.begin());
  Spring spring;
  spring.rate = 2.0 * std::numbers::pi * drive.frequency;
  spring.damping_ratio = drive.damping_ratio;
  if (drive.max_torque) spring.most = *drive.max_torque;
  if (drive.strength) LimitByMuscles(figure, joint, *drive.strength, &spring);
  spring.inertia = start.inertias[i];
  spring.of_ball = start.of_balls[i];
  return spring;
}

}  // namespace hazumi
