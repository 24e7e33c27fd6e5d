// With the axes a_i as columns of A a moment M does a_i . M on hinge i, so that A^T M = tau has to
// hold; the least such M is A (A^T A)^-1 tau. Three hinges of a ball joint line up at its poles:
// nearer than 10 degrees, at a distance d, it is
//   M = A (A^T A + lambda^2 1)^-1 tau,   lambda = sin(10 deg) f(d),
// f rising from 0 at 10 degrees to 1 at the pole, with two derivatives.

#include "engine/passive/forces/hinge_moment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kNear = 10.0 * kDegree;
constexpr double kMostDamping = 0.17364817766693033;  // sin(10 deg)

double Damping(const small::V3& outer, const small::V3& inner) {
  const small::V3 cross = Cross(outer, inner);
  const double sine = std::sqrt(Dot(cross, cross));
  if (sine >= kMostDamping) return 0.0;
  const double s = 1.0 - std::asin(sine) / kNear;
  return kMostDamping * s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

}  // namespace

small::V3 MomentOfHinges(const small::V3* axes, int num_axes, const double* torques) {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> A(3, num_axes);
  for (int k = 0; k < num_axes; ++k) A.col(k) = axes[k].eigen();
  const Eigen::Map<const VecX> tau(torques, num_axes);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram = A.transpose() * A;
  if (num_axes == 3) {
    const double damping = Damping(axes[0], axes[2]);
    if (damping > 0.0) gram.diagonal().array() += damping * damping;
  }
  return small::V3(Vec3(A * gram.partialPivLu().solve(tau)));
}

small::V3 MomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques) {
  return MomentOfHinges(node.axis.data(), num_dofs, torques);
}

}  // namespace hazumi
