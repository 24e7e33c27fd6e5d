// Block by block [Gauss, Seidel], each as if the others were right:
//   push      l = max(0, l - w / A_ll)
//   across    l_t - w_t / a  in the disk with radius friction l_n,  a the stiffest of A_tt
// w is kept along: most of what is near does not push, and costs nothing.

#include <algorithm>
#include <cmath>

#include "engine/matrix/dense_kernels.h"
#include "engine/region/contact/cone_problem.h"
#include "engine/spatial/checks.h"

namespace hazumi {

double SweepCones(const ConeProblem& problem, int most, VecX* forces, double* products) {
  HAZUMI_ASSERT(forces->size() == problem.b.size());
  HAZUMI_ASSERT(most > 0);
  constexpr double kEnough = 1e-6, kGivesWay = 1e-6;
  const MatX& A = problem.A;
  const DenseKernels& kernels = BestDenseKernels();
  VecX& l = *forces;
  VecX w = A * l + problem.b;
  const auto step_of = [&](double own) {
    return own > 0.0 ? 1.0 / ((1.0 + kGivesWay) * own) : 0.0;
  };
  double largest = 0.0, change = 0.0;
  Eigen::Index columns = w.size();  // that were multiplied
  for (int sweep = 0; sweep < most; ++sweep) {
    change = 0.0;
    for (const ConeProblem::Block& block : problem.blocks) {
      const int i = block.row;
      double to = l[i] - step_of(A(i, i)) * w[i];
      if (block.kind != ConeProblem::Kind::kBoth) to = std::max(0.0, to);
      const double by = to - l[i];
      l[i] = to;
      change = std::max(change, std::abs(by));
      largest = std::max(largest, std::abs(to));
      if (block.kind != ConeProblem::Kind::kContact) {
        if (by == 0.0) continue;
        w += by * A.col(i);
        ++columns;
        continue;
      }
      Vec3 less(-by, 0.0, 0.0);
      Eigen::Ref<Eigen::Vector2d> t = l.segment<2>(i + 1);
      const double radius = block.friction * to;
      Eigen::Vector2d across = Eigen::Vector2d::Zero();
      if (radius > 0.0) {
        const double p = A(i + 1, i + 1), q = A(i + 2, i + 2), r = A(i + 1, i + 2);
        const double stiffest = 0.5 * (p + q) + std::sqrt(0.25 * (p - q) * (p - q) + r * r);
        across = t - step_of(stiffest) * (w.segment<2>(i + 1) + by * A.block<2, 1>(i + 1, i));
        const double size = across.norm();
        if (size > radius) across *= radius / size;
        change = std::max(change, (across - t).lpNorm<Eigen::Infinity>());
      }
      less.tail<2>() = t - across;
      t = across;
      if (less.isZero(0.0)) continue;
      kernels.subtract_three(&A(0, i), A.outerStride(), less.data(), w.size(), w.data());
      columns += 3;
    }
    if (change <= kEnough * largest) break;
  }
  if (products) *products += static_cast<double>(columns * w.size());
  return change <= kEnough * largest ? 0.0 : change / largest;
}

}  // namespace hazumi
