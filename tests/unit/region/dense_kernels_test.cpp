// The loops of dense equations: beside Eigen's, and the same bits by both instruction sets.

#include "engine/matrix/dense_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <vector>

#include "engine/matrix/semidefinite.h"
#include "engine/spatial/lanes/cpu.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

MatX RandomMatrix(Eigen::Index rows, Eigen::Index columns, Random* random) {
  MatX X(rows, columns);
  for (double& x : X.reshaped()) x = random->Uniform(-1.0, 1.0);
  return X;
}

std::vector<DenseKernels> AllKernels() {
  std::vector<DenseKernels> all = {BaselineDenseKernels()};
  if (CpuHasAvx2()) all.push_back(Avx2DenseKernels());
  return all;
}

// What each does for n rows and so many columns: numbers, one after the other.
std::vector<double> Results(const DenseKernels& kernels, Eigen::Index n, Eigen::Index columns) {
  Random random(static_cast<uint64_t>(100 * n + columns));
  const MatX J = RandomMatrix(n, n, &random);
  const MatX A = J * J.transpose() + MatX::Identity(n, n);
  MatX L = A, X = RandomMatrix(n, columns, &random), Y = RandomMatrix(n, columns + 1, &random);
  const MatX X_before = X;
  EXPECT_EQ(kernels.factor(L.data(), n, n), 0);
  const MatX lower = L.triangularView<Eigen::Lower>();
  EXPECT_LT((lower * lower.transpose() - A).norm(), 1e-12 * A.norm()) << n;
  kernels.solve_lower(L.data(), n, n, X.data(), n, columns);
  EXPECT_LT((lower * X - X_before).norm(), 1e-12 * (1.0 + X_before.norm())) << n;
  MatX product(columns, columns + 1), square(columns, columns);
  kernels.product(X.data(), n, columns, Y.data(), n, columns + 1, n, product.data(), columns);
  kernels.product(X.data(), n, columns, X.data(), n, columns, n, square.data(), columns);
  EXPECT_LT((product - X.transpose() * Y).norm(), 1e-13 * (1.0 + product.norm())) << n;
  EXPECT_LT((square - X.transpose() * X).norm(), 1e-13 * (1.0 + square.norm())) << n;
  EXPECT_EQ(square, MatX(square.transpose()));
  const MatX three = RandomMatrix(n, 3, &random);
  VecX y = RandomMatrix(n, 1, &random), rounded = three * Vec3(0.3, -0.2, 0.7);
  const VecX y_before = y;
  const Vec3 abc(0.3, -0.2, 0.7);
  kernels.subtract_three(three.data(), n, abc.data(), n, y.data());
  EXPECT_LT((y - (y_before - three * abc)).norm(), 1e-14) << n;
  kernels.subtract_three_rounded(three.data(), n, abc.data(), n, rounded.data());
  EXPECT_TRUE(rounded.isZero(0.0)) << n;
  const MatX other = RandomMatrix(n, 3, &random);
  const Vec3 def(-0.4, 0.1, 0.6);
  VecX both = y_before;
  kernels.add_threes(three.data(), other.data(), n, abc.data(), def.data(), n, both.data());
  EXPECT_LT((both - (y_before + three * abc - other * def)).norm(), 1e-14) << n;
  MatX general = RandomMatrix(n, n, &random);
  const MatX general_before = general;
  VecX solution = y;
  std::vector<long> exchanged(static_cast<size_t>(n));
  kernels.solve_general(general.data(), n, n, exchanged.data(), solution.data());
  EXPECT_LT((general_before * solution - y).norm(), 1e-12 * (1.0 + n * solution.norm())) << n;
  std::vector<double> all;
  for (const MatX& of : {lower, X, product, square, MatX(y), MatX(both), MatX(solution)}) {
    all.insert(all.end(), of.data(), of.data() + of.size());
  }
  return all;
}

TEST(DenseKernels, DoAsEigenDoesAndTheSameBitsWhateverTheSet) {
  std::vector<Eigen::Index> sizes = {200};  // more rows than are solved by eight columns
  for (Eigen::Index n = 1; n <= 41; ++n) sizes.push_back(n);
  for (const Eigen::Index n : sizes) {
    for (const Eigen::Index columns : {1, 2, 3, 7, 8, 9, 20}) {
      std::vector<std::vector<double>> results;
      for (const DenseKernels& kernels : AllKernels()) {
        results.push_back(Results(kernels, n, columns));
      }
      EXPECT_EQ(results.front(), results.back()) << n << " " << columns;
    }
  }
}

// A pivot that rounding leaves nothing of has an empty column, and what has none is not moved.
TEST(DenseKernels, WhatHasNoPivotIsNotMoved) {
  Random random(7);
  const MatX J = RandomMatrix(6, 4, &random);
  for (const DenseKernels& kernels : AllKernels()) {
    MatX L = J * J.transpose(), X = RandomMatrix(6, 5, &random);
    EXPECT_EQ(kernels.factor(L.data(), 6, 6), 2);
    kernels.solve_lower(L.data(), 6, 6, X.data(), 6, 5);
    for (Eigen::Index k = 0; k < 6; ++k) {
      if (L(k, k) > 0.0) continue;
      EXPECT_TRUE(L.col(k).tail(6 - k).isZero(0.0));
      EXPECT_TRUE(X.row(k).isZero(0.0));
    }
  }
}

}  // namespace
}  // namespace hazumi::test
