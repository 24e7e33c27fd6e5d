#pragma once

// The joints that carry another one.

#include <optional>
#include <vector>

#include "engine/figure/figure.h"

namespace hazumi {

// The joints that sit on a body; an invalid one is the root's.
std::vector<GroupIndex> ChildrenOf(JointIndex body, const Figure& figure);

// The joints that move a joint, from it towards the root: `count` of them, 0 all. Not given: its
// limb, which ends before a joint that carries others too (the chest, of an arm).
std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure);

}  // namespace hazumi
