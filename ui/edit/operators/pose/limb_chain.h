#pragma once

// Internal: the joints that carry another one, for inverse kinematics.

#include <set>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/timeline/animation.h"

namespace hazumi::edit {

// Hinges that it takes to keep both the place of a joint and how the body it sits on is turned.
inline constexpr int kFullyMovable = 6;

// Of joints, the hinges that a key moves at a frame: no region does, and they can turn.
std::vector<JointIndex> KeyedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation);

// Of these, the hinges that are not locked: those that posing may turn.
std::vector<JointIndex> PosedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation,
                                    const std::set<std::string>& locked);

// A hand, a foot or what is beyond: two joints or more of a limb carry it and nothing else.
bool EndsLimb(GroupIndex joint, const Figure& figure);

// Feet stay turned as they are while they are moved unless that is asked otherwise; hands turn. A
// foot's limb hangs on the root.
bool IsFoot(GroupIndex joint, const Figure& figure);

}  // namespace hazumi::edit
