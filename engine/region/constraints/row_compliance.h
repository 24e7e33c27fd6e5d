#pragma once

#include <vector>

#include "engine/region/constraints/constraint_row.h"

namespace hazumi {

// Compliance of the rows of constraints that have a gap to close. Their forces l follow
//   (A + C) l = C d - errors
// In directions in which the constraint is nearly singular, as a straight limb cannot be drawn in
// by its end, it only damps, by d. C and d are 0 for closed rows.
struct RowCompliance {
  MatX C;
  VecX d;
};

// Returns the compliance for A = J M^-1 J^T + G, where no joint is held by a limit. Limits and
// contacts change the response of the rows, not their compliance. `damping`: part of the errors
// that damps. The rank of a row compares the motion of its end with that of `mass` [kg], and for a
// torque with that of `mass` at an arm of 0.3 m. `least`: lower bound of C, as a part of 1 / mass.
// The bound limits the forces where limits and contacts leave no feasible motion.
RowCompliance ComplianceOf(const std::vector<ConstraintRow>& rows, const MatX& A,
                           const VecX& damping, double mass, double least);

}  // namespace hazumi
