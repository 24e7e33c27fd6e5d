#include "engine/dynamics/mixed_dynamics.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/matrix/cholesky.h"
#include "tests/support/compare.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

struct MixedProblem {
  explicit MixedProblem(uint64_t seed) : random(seed) {
    const int n = random.Integer(1, 37);
    const MatX root = Eigen::Map<const MatX>(random.Vector(n * n, 1.0).data(), n, n);
    H = root * root.transpose() + 0.1 * MatX::Identity(n, n);
    B = random.Vector(n, 10.0);
    qdd = random.Vector(n, 10.0);
    T = random.Vector(n, 10.0);
    for (int i = 0; i < n; ++i) given.push_back(random.Chance(0.4));
  }
  Random random;
  MatX H;
  VecX B, qdd, T;
  std::vector<char> given;
};

// Unknown u_i = T_i where qdd_i is given, qdd_i where T_i is: one dense system, no elimination.
VecX DenseUnknowns(const MixedProblem& p) {
  const int n = static_cast<int>(p.H.rows());
  MatX A(n, n);
  VecX rhs = -p.B;
  for (int j = 0; j < n; ++j) {
    A.col(j) = p.given[j] ? VecX(-VecX::Unit(n, j)) : VecX(p.H.col(j));
    rhs += p.given[j] ? VecX(-p.H.col(j) * p.qdd[j]) : VecX(VecX::Unit(n, j) * p.T[j]);
  }
  return A.partialPivLu().solve(rhs);
}

TEST(MixedDynamics, AgreesWithTheDenseBlockSystem) {
  Worst worst("mixed");
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    MixedProblem p(seed);
    const int n = static_cast<int>(p.H.rows());
    const VecX expected = DenseUnknowns(p);
    const VecX given_qdd = p.qdd, given_T = p.T;
    MatX A(n, n);
    VecX x(n), unknown(n), kept(n), was(n);
    ASSERT_EQ(SolveMixed(p.H, p.B, p.given, A, x, p.qdd, p.T), -1) << "seed " << seed;
    for (int i = 0; i < n; ++i) {
      unknown[i] = p.given[i] ? p.T[i] : p.qdd[i];
      kept[i] = p.given[i] ? p.qdd[i] : p.T[i];
      was[i] = p.given[i] ? given_qdd[i] : given_T[i];
    }
    EXPECT_LE(worst(RelativeDifference(unknown, expected)), 1e-9) << "seed " << seed;
    EXPECT_EQ(kept, was) << "what was given changed, seed " << seed;
  }
}

TEST(MixedDynamics, NamesTheSingularCoordinateInTheWholeMatrix) {
  MixedProblem p(3);
  const int n = static_cast<int>(p.H.rows());
  ASSERT_GT(n, 4);
  std::fill(p.given.begin(), p.given.end(), 0);
  p.given[0] = p.given[2] = 1;
  p.H.row(4).setZero();
  p.H.col(4).setZero();
  MatX A(n, n);
  VecX x(n);
  EXPECT_EQ(SolveMixed(p.H, p.B, p.given, A, x, p.qdd, p.T), 4);
}

TEST(Cholesky, AgreesWithEigen) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    const MixedProblem p(seed);
    MatX L = p.H;
    ASSERT_EQ(FactorCholesky(L), -1);
    const MatX lower = L.triangularView<Eigen::Lower>();
    EXPECT_LE(RelativeDifference(lower, MatX(p.H.llt().matrixL())), 1e-12) << "seed " << seed;
  }
}

TEST(Cholesky, ReadsTheLowerTriangleOnly) {
  const MixedProblem p(5);
  MatX L = p.H, M = p.H;
  M.triangularView<Eigen::StrictlyUpper>().setConstant(std::nan(""));
  ASSERT_EQ(FactorCholesky(L), -1);
  ASSERT_EQ(FactorCholesky(M), -1);
  EXPECT_EQ(MatX(L.triangularView<Eigen::Lower>()), MatX(M.triangularView<Eigen::Lower>()));
}

TEST(Cholesky, NamesTheFirstRowThatDependsOnThoseBefore) {
  MatX A = MatX::Identity(4, 4);
  A(3, 1) = A(1, 3) = 1.0;  // rows 1 and 3 are alike
  EXPECT_EQ(FactorCholesky(A), 3);
}

}  // namespace
}  // namespace hazumi::test
