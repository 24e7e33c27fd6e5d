#include "tests/unit/region/multipliers.h"

#include <Eigen/LU>

namespace hazumi::test {

void Multipliers::Add(const MatX& rows, const VecX& values) {
  const auto old = C.rows();
  C.conservativeResize(old + rows.rows(), M.cols());
  c.conservativeResize(old + rows.rows());
  C.bottomRows(rows.rows()) = rows;
  c.tail(rows.rows()) = values;
}

void Multipliers::Prescribe(const std::vector<char>& is_given, const VecX& values) {
  for (int i = 0; i < values.size(); ++i) {
    if (is_given[i]) Add(VecX::Unit(values.size(), i).transpose(), VecX::Constant(1, values[i]));
  }
}

VecX Multipliers::Solve() const {
  const auto n = M.rows(), k = C.rows();
  MatX A = MatX::Zero(n + k, n + k);
  A.topLeftCorner(n, n) = M;
  if (k > 0) {  // C has no columns before its first row
    A.topRightCorner(n, k) = -C.transpose();
    A.bottomLeftCorner(k, n) = C;
  }
  VecX right(n + k);
  right << rhs, c;
  return A.partialPivLu().solve(right).head(n);
}

}  // namespace hazumi::test
