#pragma once

#include <optional>

#include "engine/region/region_layout.h"

namespace hazumi {

// Small changes of the state of n free hinges, in two sets of coordinates:
// - by hinge, 2 n: of angles [rad], then of rates [rad/s];
// - by dof of a layout, 2 m: small turns [rad], then changes of velocities [rad/s]. Turns of ball
//   joints are in the body's frame, R exp(turn), as RegionLayout::Turn has it. Locked hinges have
//   none.
// Both matrices are of the state (q, qd), by free hinge.

// 2 m x 2 n: changes by dof of changes by hinge; those of locked hinges are left out.
MatX DofsFromHinges(const RegionLayout& layout, const VecX& q, const VecX& qd);

// 2 n x 2 m: changes by hinge of changes by dof; 0 of locked hinges. None if a ball joint is within
// 1e-7 rad of a pole, where the angles of its hinges have no derivative.
std::optional<MatX> HingesFromDofs(const RegionLayout& layout, const VecX& q, const VecX& qd);

}  // namespace hazumi
