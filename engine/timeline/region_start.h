#pragma once

#include <algorithm>

#include "engine/timeline/animation.h"

namespace hazumi {

// Whether a hinge starts in a region with the speed that another region, which ends there, leaves
// it with.
inline bool IsTakenOver(const DynamicsRegion& region, JointIndex hinge,
                        const Animation& animation) {
  return std::any_of(animation.regions.begin(), animation.regions.end(),
                     [&](const DynamicsRegion& other) {
                       return other.last_frame == region.first_frame &&
                              std::binary_search(other.joints.begin(), other.joints.end(), hinge);
                     });
}

}  // namespace hazumi
