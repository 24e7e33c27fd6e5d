// With the axes a_i as columns of A a moment M does a_i . M on hinge i, so that A^T M = tau has to
// hold; the least such M is A (A^T A)^-1 tau. Three hinges of a ball joint line up at its poles:
// nearer than 10 degrees, at a distance d, it is
//   M = A (A^T A + lambda^2 1)^-1 tau,   lambda = sin(10 deg) f(d),
// f rising from 0 at 10 degrees to 1 at the pole, with two derivatives. Where all of tau is wanted,
// lambda = 1e-6.

#include "engine/region/forces/hinge_moment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

namespace {

constexpr double kNear = 10.0 * kDegree;
constexpr double kMostDamping = 0.17364817766693033;  // sin(10 deg)
constexpr double kLeastDamping = 1e-6;

double Damping(const small::V3& outer, const small::V3& inner) {
  const small::V3 cross = Cross(outer, inner);
  const double sine = std::sqrt(Dot(cross, cross));
  if (sine >= kMostDamping) return 0.0;
  return kMostDamping * SmoothStep(1.0 - std::asin(sine) / kNear);
}

small::V3 MomentWith(double damping, const small::V3* axes, int num_axes, const double* torques) {
  if (num_axes == 1) return torques[0] * axes[0];
  if (num_axes == 2) {
    const double c = Dot(axes[0], axes[1]), square = 1.0 - c * c;
    return ((torques[0] - c * torques[1]) / square) * axes[0] +
           ((torques[1] - c * torques[0]) / square) * axes[1];
  }
  Mat3 A;
  A << axes[0].eigen(), axes[1].eigen(), axes[2].eigen();
  const Mat3 gram = A.transpose() * A + damping * damping * Mat3::Identity();
  return small::V3(Vec3(A * (gram.inverse() * Eigen::Map<const Vec3>(torques))));
}

}  // namespace

small::V3 MomentOfHinges(const small::V3* axes, int num_axes, const double* torques) {
  const double damping = num_axes == 3 ? Damping(axes[0], axes[2]) : 0.0;
  return MomentWith(damping, axes, num_axes, torques);
}

small::V3 FullMomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques) {
  return MomentWith(kLeastDamping, node.axis.data(), num_dofs, torques);
}

small::V3 MomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques) {
  return MomentOfHinges(node.axis.data(), num_dofs, torques);
}

}  // namespace hazumi
