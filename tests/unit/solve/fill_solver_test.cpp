#include "engine/solve/fill_solver.h"

#include <gtest/gtest.h>

#include "tests/unit/solve/chains.h"

namespace hazumi::solve {
namespace {

// A hinge known at frames 0, 10 and 30 of 31.
Chain HingeChain(Turns* turns) {
  Chain chain;
  chain.step = 1.0 / 30.0;
  chain.joints = {{Vec3::Zero(), {{Vec3::UnitY(), false}}}};
  for (int t = 0; t <= 30; ++t) {
    chain.carrier.push_back({});
    chain.bodies.push_back({{1.0, {0.0, 0.0, 0.5}, 0.01 * Mat3::Identity()}});
    const bool is_key = t == 0 || t == 10 || t == 30;
    chain.is_known.push_back({is_key ? char{1} : char{0}});
    const double angle = t <= 10 ? 0.1 * t : 1.0 - 0.1 * (t - 10);
    turns->push_back({RotationBy(angle * Vec3::UnitY())});
  }
  return chain;
}

double AngleOf(const Turns& turns, int t) {
  return TurnVector(turns[static_cast<size_t>(t)][0]).y();
}

// The spline of a single hinge is the natural cubic, but for the step from frame to frame: its
// second differences run straight from key to key and vanish at the ends.
TEST(SolveSpline, OfAHingeIsTheNaturalCubic) {
  Turns turns;
  const Chain chain = HingeChain(&turns);
  SolveSpline(chain, &turns);
  const auto bend = [&](int t) {
    return AngleOf(turns, t - 1) - 2.0 * AngleOf(turns, t) + AngleOf(turns, t + 1);
  };
  EXPECT_NEAR(AngleOf(turns, 10), 1.0, 1e-12);
  EXPECT_NEAR(AngleOf(turns, 30), -1.0, 1e-12);
  for (int t = 1; t < 10; ++t) EXPECT_NEAR(bend(t), bend(10) * t / 10.0, 1e-9) << t;
  for (int t = 11; t < 30; ++t) EXPECT_NEAR(bend(t), bend(10) * (30 - t) / 20.0, 1e-9) << t;
}

// A pendulum without gravity and viscosity: its torque is its inertia times its acceleration, so
// that the least torque is the spline again, but for chords that stand for arcs.
TEST(SolveFill, OfASinglePendulumIsItsSpline) {
  Turns spline, filled;
  const Chain chain = HingeChain(&spline);
  HingeChain(&filled);
  SolveSpline(chain, &spline);
  SolveFill(chain, {1.0, 0.0, 0.0, 0.0}, &filled);
  for (int t = 0; t <= 30; ++t) EXPECT_NEAR(AngleOf(filled, t), AngleOf(spline, t), 3e-3) << t;
}

TEST(SolveFill, KeepsWhatIsKnownAndLessensTheCost) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Turns turns;
    Chain chain = RandomChain(41, seed, &turns);
    for (size_t t = 0; t <= 40; t += 10) chain.is_known[t] = {1, 1, 1};
    const Turns before = turns;
    const SquaresReport report = SolveFill(chain, FillWeights(), &turns);
    EXPECT_LT(report.cost_after, 0.9 * report.cost_before) << seed;
    for (size_t t = 0; t <= 40; t += 10) {
      for (size_t k = 0; k < 3; ++k) EXPECT_EQ(turns[t][k], before[t][k]);
    }
  }
}

// At the least sum no unknown helps any more, in whatever direction it turns.
TEST(SolveFill, EndsWhereNoTurnLessensTheCost) {
  Turns turns;
  Chain chain = RandomChain(21, 4, &turns);
  for (size_t t = 0; t <= 20; t += 10) chain.is_known[t] = {1, 1, 1};
  const FillWeights weights = {1.0, 0.4, 0.0, 0.0};
  double cost = SolveFill(chain, weights, &turns).cost_after;
  for (int i = 0; i < 3; ++i) cost = SolveFill(chain, weights, &turns).cost_after;
  for (const size_t t : {3, 7, 15}) {
    for (size_t k = 0; k < 3; ++k) {
      for (const double by : {-0.01, 0.01}) {
        Turns other = turns;
        other[t][k] =
            TurnedOn(other[t][k], chain.joints[k],
                     VecX::Constant(static_cast<Eigen::Index>(chain.joints[k].axes.size()), by));
        Turns same = other;
        Chain still = chain;
        for (auto& known : still.is_known) known = {1, 1, 1};
        EXPECT_GT(SolveFill(still, weights, &same).cost_before, cost);
      }
    }
  }
}

TEST(SolveFill, SlowsDownAtKnownFramesIfToldTo) {
  Turns lazy, snappy;
  Chain chain = RandomChain(41, 2, &lazy);
  for (size_t t = 0; t <= 40; t += 10) chain.is_known[t] = {1, 1, 1};
  snappy = lazy;
  SolveFill(chain, FillWeights(), &lazy);
  FillWeights weights;
  weights.standing = 300.0;
  SolveFill(chain, weights, &snappy);
  const auto speed = [](const Turns& turns) {
    return TurnVector(turns[19][0].transpose() * turns[21][0]).norm();
  };
  EXPECT_LT(speed(snappy), 0.5 * speed(lazy));
}

}  // namespace
}  // namespace hazumi::solve
