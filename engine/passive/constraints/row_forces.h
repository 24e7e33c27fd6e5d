#pragma once

#include <vector>

#include "engine/passive/constraints/constraint_rows.h"

namespace hazumi {

// How the rows of constraints that have a gap to close give way: l of theirs, asked for errors,
// follows
//   (A + C) l = C d - errors
// so that in directions in which they have next to no hold, as a limb that is straight cannot be
// drawn in by its end, they only slow down, by d. Both are 0 for closed rows.
struct RowYield {
  MatX C;
  VecX d;
};

// For A = J M^-1 J^T + G of joints none of which is held by a limit: what a limit or a contact
// holds changes what the rows do, and not how they yield. `damping`: what of the errors slows down.
// A force has hold as far as it moves its end as it would move `mass` [kg]; a torque as far as it
// would turn that at an arm of 0.3 m. `least`: what C is at least, as a part of 1 / mass. Where
// limits hold hinges, or contacts leave no room, there may be no way to go at all: some of the
// forces is held back then, which bounds them.
RowYield YieldOf(const std::vector<ConstraintRow>& rows, const MatX& A, const VecX& damping,
                 double mass, double least);

}  // namespace hazumi
