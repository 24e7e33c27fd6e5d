#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi::solve {

// The normal equations (A + damping) x = -g of residuals that each touch few unknowns in a row:
// A = sum J^T J, symmetric and banded, g = sum J^T r.
class BandSystem {
 public:
  // `width`: so many unknowns in a row that one residual touches.
  BandSystem(int size, int width);

  void Clear();
  // Adds residuals r that touch the unknowns from `first` on, with their derivatives J: rows of r,
  // at most `width` columns.
  void Add(int first, const Eigen::Ref<const MatX>& J, const Eigen::Ref<const VecX>& r);
  // Adds a residual that touches some unknowns, in ascending order, `width` apart at most.
  void Add(const std::vector<int>& unknowns, const VecX& J, double r);
  // Solves it with `damping` times each diagonal entry added. Unknowns that no residual touches are
  // 0. False if A is not positive.
  bool Solve(double damping, VecX* x);

  const VecX& gradient() const { return gradient_; }

 private:
  double& Entry(std::vector<double>* rows, int i, int k) const;

  int size_, width_;
  // Row i: the entries of columns i - width + 1 to i.
  std::vector<double> rows_, factor_;
  VecX gradient_;
};

}  // namespace hazumi::solve
