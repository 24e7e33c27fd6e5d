// With c the closed rows, g the others, scaled so that A is 1 where a row has all hold,
//   S = A_gg - A_gc A_cc^-1 A_cg = U s U^T
// Along each direction of U,
//   h = SmoothStep(s / kHold)     the part of the forces that is given
//   n = SmoothStep(s / kNone)
//   C = 1 / (h / s + e) - 1 / (1 / s + e),   so that 1 / (s + C) = h / s but for e
//   d = -(1 - h) n / s of what damps

#include "engine/region/constraints/row_compliance.h"

#include <algorithm>
#include <cmath>

#include "engine/matrix/eigen_system.h"
#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

namespace {

// Of the hold that a row has where nothing is straight: enough, and next to none.
constexpr double kHold = 0.1, kNone = 1e-4;
constexpr double kSoftest = 1e-4;  // e: what bounds C where a row has no hold
constexpr double kArm = 0.3;       // [m]

double Step(double s) { return SmoothStep(std::clamp(s, 0.0, 1.0)); }

// By which rows and columns of S are scaled.
VecX UnitsOf(const std::vector<ConstraintRow>& rows, const std::vector<Eigen::Index>& others,
             double mass) {
  VecX units(static_cast<Eigen::Index>(others.size()));
  for (size_t i = 0; i < others.size(); ++i) {
    units[static_cast<Eigen::Index>(i)] = std::sqrt(mass) * (rows[others[i]].turns ? kArm : 1.0);
  }
  return units;
}

}  // namespace

RowCompliance ComplianceOf(const std::vector<ConstraintRow>& rows, const MatX& A,
                           const VecX& damping, double mass, double least) {
  HAZUMI_ASSERT(A.rows() == static_cast<Eigen::Index>(rows.size()) && A.cols() == A.rows());
  HAZUMI_ASSERT(damping.size() == A.rows());
  HAZUMI_ASSERT(mass >= 0.0 && least >= 0.0);
  std::vector<Eigen::Index> closed, others;
  for (size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].is_contact()) continue;  // which may open, as limits may let go
    (rows[k].is_closed ? closed : others).push_back(static_cast<Eigen::Index>(k));
  }
  MatX S = A(others, others);
  const VecX unit = UnitsOf(rows, others, mass);
  const MatX A_cc = A(closed, closed), A_cg = A(closed, others);
  for (Eigen::Index k = 0; k < A_cg.cols(); ++k) {
    S.col(k) -= A_cg.transpose() * LeastNorm(A_cc, A_cg.col(k));
  }
  const MatX scaled = unit.asDiagonal() * S * unit.asDiagonal();
  const EigenSystem eigen = EigenSystemOf(0.5 * (scaled + scaled.transpose()));
  const MatX& U = eigen.vectors;
  const VecX slows = U.transpose() * unit.cwiseProduct(VecX(damping(others)));
  VecX C = VecX::Zero(slows.size()), d = C;
  for (Eigen::Index k = 0; k < slows.size(); ++k) {
    const double s = eigen.values[k], h = Step(s / kHold);
    if (h < 1.0) C[k] = 1.0 / kSoftest;
    if (s <= 0.0) continue;
    C[k] = 1.0 / (h / s + kSoftest) - 1.0 / (1.0 / s + kSoftest);
    if (const double n = Step(s / kNone); n > 0.0) d[k] = -(1.0 - h) * n / s * slows[k];
  }
  if (least > 0.0) C.array() += least;
  const VecX back = unit.cwiseInverse();
  RowCompliance compliance = {MatX::Zero(A.rows(), A.rows()), VecX::Zero(A.rows())};
  compliance.C(others, others) =
      back.asDiagonal() * U * C.asDiagonal() * U.transpose() * back.asDiagonal();
  compliance.d(others) = unit.cwiseProduct(U * d);
  return compliance;
}

}  // namespace hazumi
