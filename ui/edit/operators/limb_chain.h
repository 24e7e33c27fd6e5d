#pragma once

// Internal: the joints that carry another one, for inverse kinematics.

#include <vector>

#include "engine/figure/limb.h"
#include "engine/timeline/animation.h"

namespace hazumi::edit {

// Hinges that it takes to keep both the place of a joint and how the body it sits on is turned.
inline constexpr int kFullyMovable = 6;

// Of joints, the hinges that a key moves at a frame: no region does, and they can turn.
std::vector<JointIndex> KeyedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation);

}  // namespace hazumi::edit
