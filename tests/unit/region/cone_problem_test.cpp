// Forces of contacts, beside what each of them has to fulfil.

#include "engine/region/contact/cone_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

using Kind = ConeProblem::Kind;
using Block = ConeProblem::Block;

// Contacts, limits and what is held, each giving way a little, so that there is one solution.
ConeProblem RandomProblem(uint64_t seed) {
  Random random(seed);
  ConeProblem problem;
  int rows = 0;
  for (int i = random.Integer(2, 8); i > 0; --i) {
    const int kind = random.Integer(0, 3);
    const Kind own = kind == 0 ? Kind::kBoth : kind == 1 ? Kind::kPush : Kind::kContact;
    problem.blocks.push_back({own, rows, random.Chance(0.2) ? 0.0 : random.Uniform(0.1, 0.8)});
    rows += own == Kind::kContact ? 3 : 1;
  }
  MatX J(rows, rows + 2);
  for (Eigen::Index k = 0; k < J.cols(); ++k) J.col(k) = random.Vector(rows, 1.0);
  problem.A = J * J.transpose() + 0.1 * MatX::Identity(rows, rows);
  problem.b = random.Vector(rows, 1.0);
  return problem;
}

// What is left of the conditions, as velocities and forces.
double LeftOf(const ConeProblem& problem, const VecX& l) {
  const VecX w = problem.A * l + problem.b;
  double left = 0.0;
  for (const Block& block : problem.blocks) {
    const int i = block.row;
    if (block.kind == Kind::kBoth) {
      left = std::max(left, std::abs(w[i]));
      continue;
    }
    left = std::max({left, -l[i], -w[i], std::min(l[i], w[i])});
    if (block.kind != Kind::kContact) continue;
    const double most = block.friction * l[i];
    const Eigen::Vector2d force = l.segment<2>(i + 1), slide = w.segment<2>(i + 1);
    left = std::max(left, force.norm() - most);
    // It takes as much as it can where it slides: |slide| most = -slide . force
    left = std::max(left, slide.norm() * most + slide.dot(force));
    if (most - force.norm() > 1e-4) left = std::max(left, slide.norm());
  }
  return left;
}

TEST(ConeProblem, ForcesFulfilWhatTheyHaveTo) {
  for (int seed = 1; seed <= 1000; ++seed) {
    const ConeProblem problem = RandomProblem(seed);
    VecX forces;
    ASSERT_TRUE(SolveCones(problem, &forces)) << seed;
    EXPECT_LT(LeftOf(problem, forces), 1e-8) << seed;
    VecX inside;
    ASSERT_TRUE(SolveConesInside(problem, &inside)) << seed;
    EXPECT_LT(LeftOf(problem, inside), 1e-4) << seed;
  }
}

TEST(ConeProblem, NearForcesAreFoundByNewtonsStepsAndElseLeftAsTheyAre) {
  int found = 0;
  for (int seed = 1; seed <= 1000; ++seed) {
    const ConeProblem problem = RandomProblem(seed);
    VecX forces;
    ASSERT_TRUE(SolveCones(problem, &forces)) << seed;
    const VecX start = forces + Random(seed).Vector(static_cast<int>(forces.size()), 1e-3);
    VecX near = start;
    if (!SolveConesNear(problem, &near)) {
      EXPECT_EQ(near, start) << seed;
      continue;
    }
    ++found;
    EXPECT_LT(LeftOf(problem, near), 1e-4) << seed;
    // Velocities that they change lose energy.
    EXPECT_LE(near.dot(0.5 * (problem.A * near) + problem.b), 0.0) << seed;
  }
  EXPECT_GT(found, 800);
}

// The limit of work of a bake depends on it.
TEST(ConeProblem, EachSearchCountsItsMultiplications) {
  const ConeProblem problem = RandomProblem(1);
  const double rows = static_cast<double>(problem.b.size());
  const auto counted = [&](const auto& search, const ConeProblem& of) {
    VecX forces = VecX::Ones(of.b.size());
    double products = 1.0;  // of before
    search(of, &forces, &products);
    return products - 1.0;
  };
  const auto sweep = [](const ConeProblem& of, VecX* forces, double* products) {
    SweepCones(of, 3, forces, products);
  };
  EXPECT_GE(counted(sweep, problem), rows * rows);
  EXPECT_GE(counted(SolveCones, problem), rows * rows);
  EXPECT_GT(counted(SolveConesNear, problem), 0.0);
  EXPECT_GE(counted(SolveConesInside, problem), rows * rows * rows / 3.0);
}

TEST(ConeProblem, SweepsComeNearAndStayInTheCones) {
  for (int seed = 1; seed <= 200; ++seed) {
    const ConeProblem problem = RandomProblem(seed);
    VecX forces = VecX::Zero(problem.b.size());
    const double few = SweepCones(problem, 3, &forces);
    EXPECT_LE(forces.dot(0.5 * (problem.A * forces) + problem.b), 1e-12) << seed;
    const double many = SweepCones(problem, 2000, &forces);
    EXPECT_LE(many, few) << seed;
    EXPECT_LT(LeftOf(problem, forces), 1e-3) << seed;
  }
}

}  // namespace
}  // namespace hazumi::test
