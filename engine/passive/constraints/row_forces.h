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

// Returns the compliance for A = J M^-1 J^T + G, where no joint is held by a limit. Limits and
// contacts change the response of the rows, not their compliance. `damping`: part of the errors
// that damps. The rank of a row compares the motion of its end with that of `mass` [kg], and for a
// torque with that of `mass` at an arm of 0.3 m. `least`: lower bound of C, as a part of 1 / mass.
// The bound limits the forces where limits and contacts leave no feasible motion.
RowYield YieldOf(const std::vector<ConstraintRow>& rows, const MatX& A, const VecX& damping,
                 double mass, double least);

}  // namespace hazumi
