#pragma once

// Internal. Which joints are limbs.

#include <vector>

#include "engine/figure/figure.h"

namespace hazumi::makers {

// Row of joints from the one that sits on the trunk outwards: neck and head, arms down to the hand,
// legs, tails. Parts that it carries besides, as fingers, move along.
using Limb = std::vector<GroupIndex>;

// Limbs of a figure. Joints that carry two limbs or more are trunk; parts below 1 % of the mass
// are no limbs.
std::vector<Limb> LimbsOf(const Figure& figure);

// Whether a limb is a leg, whose weight the ground carries.
bool IsLeg(const Limb& limb, const Figure& figure);

}  // namespace hazumi::makers
