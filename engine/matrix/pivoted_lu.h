#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// P A = L U with the largest element of each column as pivot, for a dozen unknowns: plain loops,
// where a library's blocks and calls cost more than the arithmetic.
class PivotedLu {
 public:
  explicit PivotedLu(int size) : lu_(size, size), rows_(size) {}

  void Factor(const MatX& A);
  // Of the factors on the diagonal, by absolute value; NaN if any is.
  double least_pivot() const { return least_pivot_; }
  // x = A^-1 b; neither may be the other.
  void Solve(const VecX& b, VecX* x) const;

 private:
  MatX lu_;                // L below the diagonal, U on it and above
  std::vector<int> rows_;  // which row of A is in which row
  double least_pivot_ = 0.0;
};

}  // namespace hazumi
