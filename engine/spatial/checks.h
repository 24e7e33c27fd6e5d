#pragma once

#include <algorithm>

#include "engine/base/assert.h"
#include "engine/spatial/small.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Predicates for assertions. Steps that are too long may end in numbers that are not finite, and
// are taken again: symmetry and signs count as kept there.

template <typename Derived>
bool IsFinite(const Eigen::DenseBase<Derived>& x) {
  return x.derived().allFinite();
}
inline bool IsFinite(const small::V3& v) { return IsFinite(v.eigen()); }

// Whether a square matrix is symmetric to rounding.
template <typename Derived>
bool IsSymmetric(const Eigen::MatrixBase<Derived>& A) {
  constexpr double kRounding = 1e-9;  // relative to the largest entry
  if (A.rows() != A.cols()) return false;
  if (A.size() == 0) return true;
  const double largest = A.cwiseAbs().maxCoeff();
  return !((A - A.transpose()).cwiseAbs().maxCoeff() > kRounding * largest);
}

// Whether no entry is negative.
template <typename Derived>
bool IsNonnegative(const Eigen::DenseBase<Derived>& x) {
  return x.size() == 0 || !(x.derived().minCoeff() < 0.0);
}

inline bool IsUnit(const small::V3& n) {
  constexpr double kRounding = 1e-6;
  return !(std::abs(Dot(n, n) - 1.0) > kRounding);
}

// Whether R R^T = 1.
inline bool IsRotation(const Mat3& R) {
  constexpr double kRounding = 1e-6;
  return !((R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() > kRounding);
}

}  // namespace hazumi
