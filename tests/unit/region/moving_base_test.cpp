// The fitted motion of a carrier against the chain that it was fitted to.

#include "engine/region/moving_base.h"

#include <gtest/gtest.h>

#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

using small::V3;
using Frame = MovingBase::Frame;

// Turns about z at the rate w + b cos(b t) / 2 while it shakes along x: closed forms.
struct Shaker {
  double w, b;
  int* calls = nullptr;

  Frame operator()(double t) const {
    if (calls) ++*calls;
    const double angle = w * t + 0.5 * std::sin(b * t);
    const double s = std::sin(angle), c = std::cos(angle);
    Frame frame;
    frame.R = {{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
    frame.w = {0.0, 0.0, w + 0.5 * b * std::cos(b * t)};
    frame.alpha = {0.0, 0.0, -0.5 * b * b * std::sin(b * t)};
    frame.a = {-b * b * std::cos(b * t), 0.0, 9.81};
    return frame;
  }
};

double Size(const V3& v) { return v.eigen().norm(); }

// As a part of the largest number of its kind.
double Difference(const Frame& a, const Frame& b, double size) {
  const double turn = (a.R.eigen() - b.R.eigen()).norm();
  const double rest = Size(a.w - b.w) + Size(a.alpha - b.alpha) + Size(a.a - b.a);
  return turn + rest / (1.0 + size);
}

double WorstDifference(const MovingBase& moving_base, const Shaker& chain, double start,
                       double end) {
  constexpr int kLooks = 1000;
  const double size = chain.b * chain.b + std::abs(chain.w);
  double worst = 0.0;
  for (int i = 0; i <= kLooks; ++i) {
    const double t = i == kLooks ? end : start + (end - start) * i / kLooks;
    worst = std::max(worst, Difference(moving_base.At(t), chain(t), size));
  }
  return worst;
}

TEST(MovingBase, IsTheChainToRoundingHoweverFastItMoves) {
  for (const double b : {0.0, 1.0, 20.0, 300.0, 5000.0}) {
    for (const double end : {1e-5, 1.0 / 30.0, 1.0}) {
      const Shaker chain{0.3 * b, b};
      const MovingBase moving_base(-0.5, -0.5 + end, -0.5 + end, chain);
      EXPECT_TRUE(moving_base.Covers(-0.5 + end));
      EXPECT_LE(WorstDifference(moving_base, chain, -0.5, -0.5 + end), 1e-9)
          << b << " 1/s for " << end << " s";
    }
  }
}

TEST(MovingBase, IsTheChainOfARandomTree) {
  int moved = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const auto island = RandomIsland::Of(seed, RootCoupling::kPrescribed);
    if (!island) continue;
    RegionDynamics dynamics(island->model, ForceLaws(), RandomIsland::kGravity);
    RegionKinematics& kinematics = dynamics.kinematics();
    const RegionLayout layout(island->model, /*balls=*/true);
    kinematics.SetCurves(&island->driven, -0.05, layout);
    if (!kinematics.needs_moving_base()) continue;
    ++moved;
    const auto moving_base = kinematics.FitMovingBase(-0.05, 0.25, layout);
    NodeKinematics chain(island->model);
    const int first = kinematics.first_moved(), carrier = island->model.nodes[first].parent;
    for (double t = -0.05; t <= 0.25; t += 0.01) {
      chain.Move(layout, island->driven, t, nullptr, nullptr, 0, first);
      const NodeMotion& own = chain.motion()[carrier];
      const auto& root = island->driven.root_position;
      const V3 base(root[0].At(t).dd, root[1].At(t).dd, root[2].At(t).dd + RandomIsland::kGravity);
      const Frame expected = {own.R, own.w, own.alpha, own.a + base};
      const double size = Size(own.w) + Size(own.alpha) + Size(own.a);
      EXPECT_LE(Difference(moving_base->At(t), expected, size), 1e-8) << "seed " << seed;
    }
  }
  EXPECT_GT(moved, 20);
}

// Half a turn changes the sign of a quaternion's parts.
TEST(MovingBase, TurnsRoundAndRound) {
  const Shaker chain{40.0, 0.0};
  const MovingBase moving_base(0.0, 2.0, 2.0, chain);
  EXPECT_LE(WorstDifference(moving_base, chain, 0.0, 2.0), 1e-10);
}

TEST(MovingBase, NeedsNoTime) {
  const Shaker chain{3.0, 2.0};
  const MovingBase moving_base(0.7, 0.7, 0.7, chain);
  EXPECT_TRUE(moving_base.Covers(0.7));
  EXPECT_LE(Difference(moving_base.At(0.7), chain(0.7), 1.0), 1e-12);
}

// Polynomials of degree 13 over 0.15 s at most: a slow second takes seven fits of 14 points, and no
// more but for what was tried in vain.
TEST(MovingBase, AsksTheChainForFourteenPointsAFit) {
  int calls = 0;
  const MovingBase slow(0.0, 1.0, 1.0, Shaker{1.0, 1.0, &calls});
  EXPECT_EQ(calls, 7 * 14);
  int fast_calls = 0;
  const MovingBase fast(0.0, 1.0, 1.0, Shaker{1.0, 300.0, &fast_calls});
  EXPECT_GT(fast_calls, 10 * calls);
  EXPECT_LT(fast_calls, 300 * calls);
}

// What breaks off in the middle is cut into ever shorter fits there, and no shorter than 0.1 ms.
TEST(MovingBase, GoesOnBehindAPlaceThatNoPolynomialFits) {
  int calls = 0;
  const auto chain = [&](double t) {
    Frame frame = Shaker{1.0, 2.0, &calls}(t);
    if (t > 0.31415) frame.a.y = 5.0;
    return frame;
  };
  const MovingBase moving_base(0.0, 1.0, 1.0, chain);
  EXPECT_TRUE(moving_base.Covers(1.0));
  EXPECT_LT(calls, 14 * 100);
  for (const double t : {0.1, 0.313, 0.3155, 0.7, 1.0}) {
    EXPECT_LE(Difference(moving_base.At(t), chain(t), 5.0), 1e-8) << t;
  }
}

TEST(MovingBase, GivesUpLateInAMotionThatIsTooWild) {
  const Shaker chain{1.0, 1e6};
  const MovingBase moving_base(0.0, 10.0, 10.0, chain);
  EXPECT_TRUE(moving_base.Covers(0.0));
  EXPECT_FALSE(moving_base.Covers(10.0));
  double t = 10.0;
  while (!moving_base.Covers(t)) t *= 0.5;
  EXPECT_GT(t, 0.0);
}

// Independence of the end of a motion, which may be cut anywhere.
TEST(MovingBase, DoesNotDependOnTheRequestedEnd) {
  int calls = 0;
  const Shaker chain{1.0, 3.0, &calls};
  const MovingBase shorter(0.0, 0.4, 2.0, chain), longer(0.0, 1.1, 2.0, chain);
  for (double t = 0.0; t <= 0.4 + DrivenMotion::kLongestCut; t += 0.01) {
    const MovingBase::Frame a = shorter.At(t), b = longer.At(t);
    EXPECT_EQ(a.R.eigen(), b.R.eigen()) << t;
    EXPECT_EQ(a.alpha.eigen(), b.alpha.eigen()) << t;
    EXPECT_EQ(a.a.eigen(), b.a.eigen()) << t;
  }
}

TEST(MovingBase, EndsWhereTheChainGivesNoNumbers) {
  const auto chain = [](double) {
    Frame frame = Shaker{1.0, 1.0}(0.0);
    frame.a.x = std::numeric_limits<double>::quiet_NaN();
    return frame;
  };
  const MovingBase moving_base(0.0, 0.1, 0.1, chain);
  EXPECT_TRUE(std::isnan(moving_base.At(0.05).a.x));
}

// Dynamics with the same carrier may share a fit: the same bits as each with its own.
TEST(MovingBase, IsTheSameSharedAsMadeTwice) {
  int shared = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const auto island = RandomIsland::Of(seed, RootCoupling::kPrescribed);
    if (!island) continue;
    RegionDynamics own(island->model, ForceLaws(), RandomIsland::kGravity);
    RegionDynamics other(island->model, ForceLaws(), RandomIsland::kGravity);
    own.SetDriven(&island->driven, -0.05, 0.05);
    const RegionLayout& layout = other.layout();
    other.kinematics().SetCurves(&island->driven, -0.05, layout);
    if (!other.kinematics().needs_moving_base()) continue;
    ++shared;
    RegionDynamics third(island->model, ForceLaws(), RandomIsland::kGravity);
    third.kinematics().SetCurves(&island->driven, -0.05, layout);
    other.kinematics().UseMovingBase(third.kinematics().FitMovingBase(-0.05, 0.05, layout));
    VecX y(own.layout().state_size()), dy(y.size()), other_dy(y.size());
    own.layout().Pack(island->q, island->qd, y.data());
    own.Derivative(0.0123, y.data(), dy.data());
    other.Derivative(0.0123, y.data(), other_dy.data());
    EXPECT_EQ(dy, other_dy) << "seed " << seed;
  }
  EXPECT_GT(shared, 10);
}

}  // namespace
}  // namespace hazumi::test
