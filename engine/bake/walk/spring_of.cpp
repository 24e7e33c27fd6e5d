#include "engine/bake/walk/spring_of.h"

#include <algorithm>
#include <numbers>

namespace hazumi {

Spring SpringOf(const Drive& drive, JointIndex joint, const DynamicsRegion& region,
                const RegionStart& start) {
  const auto found = std::lower_bound(region.joints.begin(), region.joints.end(), joint);
  const auto i = static_cast<size_t>(found - region.joints.begin());
  Spring spring;
  spring.rate = 2.0 * std::numbers::pi * drive.frequency;
  spring.damping_ratio = drive.damping_ratio;
  if (drive.max_torque) spring.most = *drive.max_torque;
  spring.inertia = start.inertias[i];
  spring.of_ball = start.of_balls[i];
  return spring;
}

}  // namespace hazumi
