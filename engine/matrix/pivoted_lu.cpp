#include "engine/matrix/pivoted_lu.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hazumi {

void PivotedLu::Factor(const MatX& A) {
  const int n = static_cast<int>(A.rows());
  lu_ = A;
  std::iota(rows_.begin(), rows_.end(), 0);
  least_pivot_ = std::numeric_limits<double>::infinity();
  for (int k = 0; k < n; ++k) {
    double* const column = &lu_(0, k);
    int pivot = k;
    for (int i = k + 1; i < n; ++i) {
      if (std::abs(column[i]) > std::abs(column[pivot])) pivot = i;
    }
    if (pivot != k) {
      std::swap(rows_[k], rows_[pivot]);
      for (int j = 0; j < n; ++j) std::swap(lu_(k, j), lu_(pivot, j));
    }
    const double size = std::abs(column[k]);
    if (std::isnan(size) || size < least_pivot_) least_pivot_ = size;
    const double inverse = 1.0 / column[k];
    for (int i = k + 1; i < n; ++i) column[i] *= inverse;
    for (int j = k + 1; j < n; ++j) {
      double* const other = &lu_(0, j);
      const double factor = other[k];
      if (factor == 0.0) continue;
      for (int i = k + 1; i < n; ++i) other[i] -= factor * column[i];
    }
  }
}

void PivotedLu::Solve(const VecX& b, VecX* x) const {
  const int n = static_cast<int>(b.size());
  for (int i = 0; i < n; ++i) (*x)[i] = b[rows_[i]];
  for (int k = 0; k < n; ++k) {
    for (int i = k + 1; i < n; ++i) (*x)[i] -= (*x)[k] * lu_(i, k);
  }
  for (int k = n - 1; k >= 0; --k) {
    (*x)[k] /= lu_(k, k);
    for (int i = 0; i < k; ++i) (*x)[i] -= (*x)[k] * lu_(i, k);
  }
}

}  // namespace hazumi
