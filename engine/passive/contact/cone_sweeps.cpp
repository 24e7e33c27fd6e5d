// Block by block [Gauss, Seidel], each as if the others were right:
//   push      l = max(0, l - w / A_ll)
//   across    l_t - w_t / a  in the disk with radius friction l_n,  a the stiffest of A_tt

#include <algorithm>
#include <cmath>

#include "engine/passive/contact/cone_problem.h"
#include "engine/passive/dense_kernels.h"

namespace hazumi {

bool SweepCones(const ConeProblem& problem, VecX* forces) {
  constexpr int kMostSweeps = 60;
  constexpr double kEnough = 1e-6, kGivesWay = 1e-6;
  const MatX rows = problem.A.transpose();
  const DenseKernels& kernels = BestDenseKernels();
  VecX& l = *forces;
  const auto step_of = [&](double own) {
    return own > 0.0 ? 1.0 / ((1.0 + kGivesWay) * own) : 0.0;
  };
  double largest = 0.0, last = 0.0;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (const ConeProblem::Block& block : problem.blocks) {
      const int i = block.row;
      const double before = l[i];
      const bool is_contact = block.kind == ConeProblem::Kind::kContact;
      Vec3 w;
      if (is_contact) {
        kernels.dot_three(&rows(0, i), rows.outerStride(), l.data(), l.size(), w.data());
        w += problem.b.segment<3>(i);
      } else {
        w[0] = rows.col(i).dot(l) + problem.b[i];
      }
      l[i] -= step_of(rows(i, i)) * w[0];
      if (block.kind != ConeProblem::Kind::kBoth) l[i] = std::max(0.0, l[i]);
      change = std::max(change, std::abs(l[i] - before));
      largest = std::max(largest, std::abs(l[i]));
      if (!is_contact) continue;
      const double radius = block.friction * l[i];
      Eigen::Vector2d t = l.segment<2>(i + 1);
      if (radius <= 0.0) {
        l.segment<2>(i + 1).setZero();
        continue;
      }
      const Eigen::Vector2d across =
          w.tail<2>() + (l[i] - before) * rows.block<1, 2>(i, i + 1).transpose();
      const double p = rows(i + 1, i + 1), q = rows(i + 2, i + 2), r = rows(i + 1, i + 2);
      const double stiffest = 0.5 * (p + q) + std::sqrt(0.25 * (p - q) * (p - q) + r * r);
      t -= step_of(stiffest) * across;
      const double size = t.norm();
      if (size > radius) t *= radius / size;
      change = std::max(change, (t - l.segment<2>(i + 1)).lpNorm<Eigen::Infinity>());
      l.segment<2>(i + 1) = t;
    }
    if (change <= kEnough * largest) return true;
    last = change;
  }
  return last <= 1e-3 * largest;
}

}  // namespace hazumi
