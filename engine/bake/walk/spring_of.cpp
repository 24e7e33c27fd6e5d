#include <algorithm>

#include "engine/bake/walk/drive_curves.h"
#include "engine/region/ball_axes.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

namespace {

// What the hinges of a ball joint can give at rest, along the ball's axes: its first two are those
// of the first two hinges, and the third hinge lies along its third or against it.
void LimitBall(const Figure& figure, const JointGroup& group, const BallAxes& ball,
               Spring* spring) {
  for (int i = 0; i < 3; ++i) {
    const Joint& hinge = figure.joints()[group.first.value() + i];
    if (!hinge.strength) continue;
    const StrengthLimits limits = hinge.strength->At(hinge.rest, 0.0);
    const bool is_against = i == 2 && ball.is_third_against;
    (is_against ? spring->most_backward : spring->most_forward)[i] = limits.positive.torque;
    (is_against ? spring->most_forward : spring->most_backward)[i] = limits.negative.torque;
  }
}

void LimitByMuscles(const Figure& figure, JointIndex joint, double share, Spring* spring) {
  spring->muscles = figure.joint(joint).strength;
  spring->share = share;
  const JointGroup& group = figure.group(figure.joint(joint).group);
  if (const auto ball = BallAxesOf(figure, group)) LimitBall(figure, group, *ball, spring);
}

}  // namespace

Spring SpringOf(const Drive& drive, JointIndex joint, const DynamicsRegion& region,
                const Figure& figure, const RegionStart& start, FrameRate rate) {
  const auto found = std::lower_bound(region.joints.begin(), region.joints.end(), joint);
  const auto i = static_cast<size_t>(found - region.joints.begin());
  Spring spring;
  spring.reads_frequency = !drive.frequency_keys.empty();
  spring.reads_share = !drive.strength_keys.empty();
  spring.has_ahead = drive.feed_forward;
  spring.rate = RateOfFrequency(
      spring.reads_frequency ? RangeOf(drive.frequency_keys, rate).greatest : drive.frequency);
  spring.damping_ratio = drive.damping_ratio;
  if (drive.max_torque) spring.most = *drive.max_torque;
  if (IsByStrength(drive)) LimitByMuscles(figure, joint, drive.strength.value_or(1.0), &spring);
  spring.inertia = start.inertias[i];
  spring.of_ball = start.of_balls[i];
  return spring;
}

}  // namespace hazumi
