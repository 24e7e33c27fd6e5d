#include "engine/solve/band_system.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace hazumi::solve {
namespace {

TEST(BandSystem, SolvesWhatTheDenseSystemSays) {
  constexpr int kSize = 40, kWidth = 7;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  BandSystem system(kSize, kWidth);
  MatX A = MatX::Zero(kSize, kSize);
  VecX g = VecX::Zero(kSize);
  for (int first = 0; first + kWidth <= kSize; ++first) {
    const MatX J = MatX::NullaryExpr(4, kWidth, [&] { return number(random); });
    const VecX r = VecX::NullaryExpr(4, [&] { return number(random); });
    system.Add(first, J, r);
    A.block(first, first, kWidth, kWidth) += J.transpose() * J;
    g.segment(first, kWidth) += J.transpose() * r;
  }
  constexpr double kDamping = 0.01;
  VecX x;
  ASSERT_TRUE(system.Solve(kDamping, &x));
  A.diagonal() *= 1.0 + kDamping;
  EXPECT_LT((x - A.ldlt().solve(-g)).norm(), 1e-10);
}

TEST(BandSystem, LeavesAloneWhatNoResidualTouches) {
  BandSystem system(3, 2);
  system.Add(0, MatX::Identity(1, 1), VecX::Constant(1, 2.0));
  VecX x;
  ASSERT_TRUE(system.Solve(0.0, &x));
  EXPECT_EQ(x, (VecX(3) << -2.0, 0.0, 0.0).finished());
}

}  // namespace
}  // namespace hazumi::solve
