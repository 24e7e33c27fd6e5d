#pragma once

// Internal: the joints that carry another one, for inverse kinematics.

#include <optional>
#include <vector>

#include "engine/timeline/animation.h"

namespace hazumi::edit {

// Hinges that it takes to keep both the place of a joint and how the body it sits on is turned.
inline constexpr int kFullyMovable = 6;

// The joints that sit on a body; an invalid one is the root's.
std::vector<GroupIndex> ChildrenOf(JointIndex body, const Figure& figure);

// The joints that move a joint, from it towards the root: `count` of them, 0 all. Not given: its
// limb, which ends before a joint that carries others too (the chest, of an arm).
std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure);

// Of joints, the hinges that a key moves at a frame: no region does, and they can turn.
std::vector<JointIndex> KeyedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation);

}  // namespace hazumi::edit
