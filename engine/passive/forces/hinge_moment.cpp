// With the axes a_i as columns of A a moment M does a_i . M on hinge i, so that A^T M = tau has to
// hold; the least such M is A (A^T A)^-1 tau.

#include "engine/passive/forces/hinge_moment.h"

#include <Eigen/LU>

namespace hazumi {

small::V3 MomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques) {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> A(3, num_dofs);
  for (int k = 0; k < num_dofs; ++k) A.col(k) = node.axis[k].eigen();
  const Eigen::Map<const VecX> tau(torques, num_dofs);
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram = A.transpose() * A;
  return small::V3(Vec3(A * gram.partialPivLu().solve(tau)));
}

}  // namespace hazumi
