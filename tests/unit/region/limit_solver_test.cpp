// Limits that are hit or pressed together: the conditions that define the answer, and all sets of
// limits tried one by one.

#include "engine/region/exact/limit_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <optional>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr double kLimitTolerance = 1e-9;

// M x = T - b of some hinges, some of them at limits, and rates v.
struct Problem {
  // `mass`: how many directions move any; fewer than hinges make M singular.
  Problem(uint64_t seed, int hinges, int mass) : random(seed) {
    const MatX A = random.Vector(hinges * mass, 1.0).reshaped(hinges, mass);
    M = A * A.transpose();
    if (mass >= hinges) M.diagonal().array() += 0.1;
    b = M * random.Vector(hinges, 10.0);  // what the masses can answer
    impulse = M * random.Vector(hinges, 1.0);
    v = random.Vector(hinges, 5.0);
    for (int i = 0; i < hinges; ++i) side.push_back(random.Integer(-1, 1));
    solver.Resize(hinges);
  }
  int size() const { return static_cast<int>(side.size()); }
  std::vector<char> None() const { return std::vector<char>(side.size(), 0); }

  VecX AfterImpact(const VecX& with_impulse, const std::vector<char>& sticks) {
    VecX after = v;
    solver.Impact(M, with_impulse, side, sticks, &after);
    return after;
  }
  double Energy(const VecX& rates) const { return 0.5 * rates.dot(M * rates); }

  Random random;
  MatX M;
  VecX b, impulse, v;
  std::vector<int> side;
  LimitSolver solver;
};

constexpr int kProblems = 300;

Problem AnyProblem(int seed) {
  Random sizes(static_cast<uint64_t>(seed));
  const int hinges = sizes.Integer(1, 12);
  return {static_cast<uint64_t>(seed), hinges, hinges + sizes.Integer(0, 3)};
}

// At no limit p = 0; at one side p <= 0, side y <= 0, p y = 0.
void ExpectComplementary(const std::vector<int>& side, const VecX& y, const VecX& p) {
  const double small_y = kLimitTolerance * (1.0 + y.norm()),
               small_p = kLimitTolerance * (1.0 + p.norm());
  for (int i = 0; i < y.size(); ++i) {
    if (side[i] == 0) {
      EXPECT_NEAR(p[i], 0.0, small_p) << i;
      continue;
    }
    EXPECT_LE(side[i] * p[i], small_p) << i;
    EXPECT_LE(side[i] * y[i], small_y) << i;
    EXPECT_NEAR(p[i] * y[i], 0.0, small_y * (1.0 + p.norm())) << i;
  }
}

TEST(LimitSolver, ChangesRatesByImpulsesThatPushInwardsAndOnlyOnWhatStays) {
  for (int seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Problem problem = AnyProblem(seed);
    const VecX after = problem.AfterImpact(problem.impulse, problem.None());
    const VecX impulses = problem.M * (after - problem.v) - problem.impulse;
    ExpectComplementary(problem.side, after, impulses);
  }
}

TEST(LimitSolver, NeverAddsEnergyWithoutABlow) {
  int lost = 0;
  for (int seed = 0; seed < kProblems; ++seed) {
    Problem problem = AnyProblem(seed);
    const VecX after = problem.AfterImpact(VecX::Zero(problem.size()), problem.None());
    const double before_J = problem.Energy(problem.v), after_J = problem.Energy(after);
    EXPECT_LE(after_J, before_J * (1.0 + kLimitTolerance)) << "seed " << seed;
    EXPECT_NEAR(before_J - after_J, problem.Energy(after - problem.v), kLimitTolerance * before_J)
        << "seed " << seed;
    lost += after_J < 0.99 * before_J;
  }
  EXPECT_GT(lost, kProblems / 2);
}

// A hinge that a row holds moves by rounding alone. The others move as if it were none.
TEST(LimitSolver, IsNotLedRoundInCirclesByAHingeThatARowHolds) {
  for (int seed = 0; seed < kProblems; ++seed) {
    const int n = 2 + seed % 4;
    Problem problem(static_cast<uint64_t>(seed), n, n);
    problem.v[0] = problem.random.Uniform(-1e-16, 1e-16);
    for (int& side : problem.side) side = problem.random.Chance(0.5) ? 1 : -1;
    LimitRows row;
    row.J.setZero(1, n);
    row.J(0, 0) = problem.random.LogUniform(0.1, 10.0);
    row.G.setZero(1, 1);
    row.c = row.J * problem.v;
    VecX after = problem.v;
    problem.solver.Impact(problem.M, VecX::Zero(n), problem.side, problem.None(), &after, &row);

    LimitSolver others;
    others.Resize(n - 1);
    VecX expected = problem.v.tail(n - 1);
    const std::vector<int> sides(problem.side.begin() + 1, problem.side.end());
    others.Impact(problem.M.bottomRightCorner(n - 1, n - 1), VecX::Zero(n - 1), sides,
                  std::vector<char>(sides.size(), 0), &expected);
    EXPECT_NEAR(after[0], 0.0, 1e-12) << "seed " << seed;
    EXPECT_LE((after.tail(n - 1) - expected).norm(), 1e-9 * problem.v.norm()) << "seed " << seed;
  }
}

TEST(LimitSolver, LeavesWhatMovesInwardsAlone) {
  for (int seed = 0; seed < kProblems; ++seed) {
    Problem problem = AnyProblem(seed);
    for (int i = 0; i < problem.size(); ++i) {
      if (problem.side[i] * problem.v[i] > 0.0) problem.v[i] *= -1.0;
    }
    const VecX after = problem.AfterImpact(VecX::Zero(problem.size()), problem.None());
    EXPECT_LE((after - problem.v).norm(), kLimitTolerance * problem.v.norm()) << "seed " << seed;
  }
}

TEST(LimitSolver, StopsWhatSticksEvenByAPull) {
  int pulled = 0;
  for (int seed = 0; seed < kProblems; ++seed) {
    Problem problem = AnyProblem(seed);
    std::vector<char> sticks = problem.None();
    for (int i = 0; i < problem.size(); ++i) {
      sticks[i] = problem.side[i] != 0 && problem.random.Chance(0.5);
    }
    const VecX after = problem.AfterImpact(problem.impulse, sticks);
    const VecX impulses = problem.M * (after - problem.v) - problem.impulse;
    for (int i = 0; i < problem.size(); ++i) {
      if (!sticks[i]) continue;
      EXPECT_EQ(after[i], 0.0);
      pulled += problem.side[i] * impulses[i] > 0.0;
    }
    EXPECT_LE(problem.Energy(problem.AfterImpact(VecX::Zero(problem.size()), sticks)),
              problem.Energy(problem.v) * (1.0 + kLimitTolerance));
  }
  EXPECT_GT(pulled, kProblems / 4);
}

// The dense solution with a set of hinges held.
struct Mixed {
  VecX x, T;
};
Mixed WithHeld(const Problem& problem, const std::vector<char>& held) {
  std::vector<int> free;
  for (int i = 0; i < problem.size(); ++i) {
    if (!held[i]) free.push_back(i);
  }
  Mixed mixed{VecX::Zero(problem.size()), {}};
  const MatX M = problem.M(free, free);
  const VecX right = -problem.b(free);
  const VecX solved = M.llt().solve(right);
  mixed.x(free) = solved;
  mixed.T = problem.M * mixed.x + problem.b;
  return mixed;
}

TEST(LimitSolver, KeepsAtRestWhatItsLimitHasToPush) {
  for (int seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Problem problem = AnyProblem(seed);
    std::vector<char> held = problem.None();
    problem.solver.Rest(problem.M, problem.b, problem.side, problem.None(), &held);
    const VecX x = problem.solver.x(), T = problem.solver.T();
    EXPECT_LE((problem.M * x + problem.b - T).norm(), kLimitTolerance * (1.0 + problem.b.norm()));
    ExpectComplementary(problem.side, x, T);
    problem.solver.Solve(problem.M, problem.b, held);
    EXPECT_EQ(problem.solver.x(), x);
    EXPECT_EQ(problem.solver.T(), T);
  }
}

// The only set of held hinges whose solution meets all conditions, if there is but one.
std::optional<std::vector<char>> OnlySet(const Problem& problem) {
  std::optional<std::vector<char>> only;
  for (int set = 0; set < 1 << problem.size(); ++set) {
    std::vector<char> held;
    bool fits = true;
    for (int i = 0; i < problem.size(); ++i) {
      held.push_back(set >> i & 1);
      fits &= !held[i] || problem.side[i] != 0;
    }
    if (!fits) continue;
    const Mixed mixed = WithHeld(problem, held);
    for (int i = 0; i < problem.size(); ++i) {
      const double out = problem.side[i] * (held[i] ? mixed.T[i] : mixed.x[i]);
      fits &= problem.side[i] == 0 || out <= 0.0;
    }
    if (!fits) continue;
    if (only) return std::nullopt;
    only = held;
  }
  return only;
}

TEST(LimitSolver, FindsTheOneSetOfLimitsThatATrialOfAllSetsFinds) {
  for (int seed = 0; seed < kProblems; ++seed) {
    const int hinges = 1 + seed % 6;
    Problem problem(static_cast<uint64_t>(seed), hinges, hinges);
    for (int& side : problem.side) side = side == 0 ? problem.random.Integer(-1, 1) : side;
    const auto expected = OnlySet(problem);
    ASSERT_TRUE(expected) << "seed " << seed;
    std::vector<char> held = problem.None();
    problem.solver.Rest(problem.M, problem.b, problem.side, problem.None(), &held);
    EXPECT_EQ(held, *expected) << "seed " << seed;
    const Mixed mixed = WithHeld(problem, held);
    EXPECT_LE((problem.solver.x() - mixed.x).norm(), kLimitTolerance * (1.0 + mixed.x.norm()));
    EXPECT_LE((problem.solver.T() - mixed.T).norm(), kLimitTolerance * (1.0 + mixed.T.norm()));
  }
}

TEST(LimitSolver, HoldsWhatIsFixedWhicheverWayItPresses) {
  int pulled = 0;
  for (int seed = 0; seed < kProblems; ++seed) {
    Problem problem = AnyProblem(seed);
    std::vector<char> fixed = problem.None(), held = problem.None();
    for (int i = 0; i < problem.size(); ++i) {
      fixed[i] = problem.side[i] != 0 && problem.random.Chance(0.5);
    }
    problem.solver.Rest(problem.M, problem.b, problem.side, fixed, &held);
    for (int i = 0; i < problem.size(); ++i) {
      if (!fixed[i]) continue;
      EXPECT_TRUE(held[i]);
      EXPECT_EQ(problem.solver.x()[i], 0.0);
      pulled += problem.side[i] * problem.solver.T()[i] > 0.0;
    }
  }
  EXPECT_GT(pulled, kProblems / 4);
}

// Two hinges about one axis, and more hinges than directions in which anything moves: which of them
// takes an impulse is open, what comes of it is not.
TEST(LimitSolver, AnswersWhereHingesMoveTheSameMass) {
  for (int seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random sizes(static_cast<uint64_t>(seed));
    const int hinges = sizes.Integer(2, 8);
    Problem problem(static_cast<uint64_t>(seed), hinges, sizes.Integer(1, hinges - 1));
    const VecX after = problem.AfterImpact(problem.impulse, problem.None());
    ASSERT_TRUE(after.allFinite());
    const VecX impulses = problem.M * (after - problem.v) - problem.impulse;
    ExpectComplementary(problem.side, after, impulses);
    std::vector<char> held = problem.None();
    problem.solver.Rest(problem.M, problem.b, problem.side, problem.None(), &held);
    ASSERT_TRUE(problem.solver.x().allFinite());
    ExpectComplementary(problem.side, problem.solver.x(),
                        problem.M * problem.solver.x() + problem.b);
  }
}

TEST(LimitSolver, GivesNothingToAHingeThatMovesNoMass) {
  Problem problem(1, 3, 3);
  problem.M.row(1).setZero();
  problem.M.col(1).setZero();
  problem.b[1] = 0.0;
  problem.side = {0, 0, 0};
  problem.solver.Solve(problem.M, problem.b, problem.None());
  EXPECT_EQ(problem.solver.x()[1], 0.0);
  EXPECT_LE((problem.M * problem.solver.x() + problem.b).norm(), 1e-12 * problem.b.norm());
}

TEST(LimitSolver, DoesTheSameBitsAgainWhateverItWasAskedBefore) {
  for (int seed = 0; seed < 50; ++seed) {
    Problem problem = AnyProblem(seed);
    LimitSolver fresh;
    fresh.Resize(problem.size());
    VecX expected = problem.v;
    fresh.Impact(problem.M, problem.impulse, problem.side, problem.None(), &expected);
    std::vector<char> held = problem.None();
    problem.solver.Rest(problem.M, problem.b, problem.side, problem.None(), &held);
    EXPECT_EQ(problem.AfterImpact(problem.impulse, problem.None()), expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hazumi::test
