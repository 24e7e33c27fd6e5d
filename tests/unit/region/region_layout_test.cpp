// States of free joints: angles and rates there and back.

#include "engine/region/region_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNever = std::numeric_limits<double>::infinity();
using Kind = RegionLayout::NodeKind;

// A root with a ball joint (y x z), a hinge about y on it, and a hinge about z on that.
RegionModel BallAndTwoHinges() {
  const auto hinge = [](Coordinate c, const Vec3& axis) { return NodeHinge{c, axis, 3, 1.0}; };
  RegionModel model;
  model.nodes.resize(4);
  for (int i = 1; i < 4; ++i) {
    model.nodes[i].parent = i - 1;
    model.nodes[i].role = Role::kFree;
    model.nodes[i].num_hinges = i == 1 ? 3 : 1;
  }
  model.nodes[1].is_ball = true;
  model.nodes[1].hinges = {hinge(0, Vec3::UnitY()), hinge(1, Vec3::UnitX()),
                           hinge(2, Vec3::UnitZ())};
  model.nodes[2].hinges[0] = hinge(3, Vec3::UnitY());
  model.nodes[3].hinges[0] = hinge(4, Vec3::UnitZ());
  model.num_free = 5;
  return model;
}

struct State {
  VecX q, qd;
};

VecX Packed(const RegionLayout& layout, const State& state) {
  VecX y(layout.state_size());
  layout.Pack(state.q, state.qd, y.data());
  return y;
}

// From angles nearby; with limits or without.
State Unpacked(const RegionLayout& layout, const VecX& y, const VecX& near, double limit = kNever) {
  const auto n = near.size();
  State state{near, VecX::Zero(n)};
  layout.Unpack(y.data(), VecX::Constant(n, -limit), VecX::Constant(n, limit), &state.q, &state.qd);
  return state;
}

VecX Five(double a, double b, double c, double d, double e) {
  VecX five(5);
  five << a, b, c, d, e;
  return five;
}

TEST(RegionLayout, ABallIsAQuaternionAndThreeRatesAHingeOneAngleAndOneRate) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  EXPECT_EQ(layout.num_hinges(), 5);
  EXPECT_EQ(layout.num_positions(), 6);
  EXPECT_EQ(layout.num_dofs(), 5);
  EXPECT_EQ(layout.node(1).kind, Kind::kBall);
  EXPECT_EQ(layout.node(0).kind, Kind::kStill);
  EXPECT_EQ(layout.angles(), (std::vector<int>{4, 5}));
  for (int i = 0; i < 6; ++i) EXPECT_EQ(layout.is_quaternion(i), i < 4);
  const int hinge_of[] = {0, 0, 0, 0, 3, 4, 0, 0, 0, 3, 4};
  for (int i = 0; i < 11; ++i) EXPECT_EQ(layout.HingeOf(i), hinge_of[i]) << i;
}

TEST(RegionLayout, WithoutBallsAStateIsTheAnglesAndRates) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/false);
  const State state{Five(0.1, 0.2, 0.3, 0.4, 0.5), Five(1, 2, 3, 4, 5)};
  const VecX y = Packed(layout, state);
  ASSERT_EQ(y.size(), 10);
  EXPECT_EQ(y.head(5), state.q);
  EXPECT_EQ(y.tail(5), state.qd);
  EXPECT_EQ(layout.triple(1), nullptr);
}

TEST(RegionLayout, GivesBackTheAnglesAndRatesThatItTook) {
  int balls = 0;
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const auto island = RandomIsland::Of(seed, RootCoupling::kFlight);
    if (!island) continue;
    RegionLayout layout(island->model, /*balls=*/true);
    balls += layout.num_positions() - layout.num_dofs();
    std::vector<char> locked;
    for (double& rate : island->qd) {
      locked.push_back(seed % 2 == 1 && island->random.Chance(0.2));
      if (locked.back()) rate = 0.0;
    }
    layout.SetLocked(locked, island->q);
    const VecX near = island->q + island->random.Vector(layout.num_hinges(), 0.1);
    const State back = Unpacked(layout, Packed(layout, {island->q, island->qd}), near);
    EXPECT_LE((back.q - island->q).lpNorm<Eigen::Infinity>(), 1e-13) << "seed " << seed;
    EXPECT_LE((back.qd - island->qd).lpNorm<Eigen::Infinity>(), 1e-12) << "seed " << seed;
  }
  EXPECT_GT(balls, 50);
}

// The rates of a ball's state are the angular velocity that its orientation has.
TEST(RegionLayout, TheVelocityOfABallIsThatOfItsRotationInTheBodysFrame) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  constexpr double kStep = 1e-6;
  const State state{Five(0.7, -0.4, 1.2, 0, 0), Five(2, -3, 1.5, 0, 0)};
  const auto rotation = [&](double t) {
    return RotationOfQuaternion(Packed(layout, {state.q + t * state.qd, state.qd}).data());
  };
  const Mat3 R_dot = (rotation(kStep) - rotation(-kStep)) / (2.0 * kStep);
  const Mat3 spin = rotation(0.0).transpose() * R_dot;
  const Vec3 w(spin(2, 1), spin(0, 2), spin(1, 0));
  EXPECT_LE((w - Packed(layout, state).segment<3>(6)).norm(), 1e-8);
}

TEST(RegionLayout, ALongQuaternionIsTheSameRotation) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const State state{Five(0.7, -0.4, 1.2, 0.1, 0.2), Five(2, -3, 1.5, 1, 2)};
  VecX y = Packed(layout, state);
  for (const double factor : {-1.0, 1.001, 3.0}) {
    VecX scaled = y;
    scaled.head(4) *= factor;
    EXPECT_LE((Unpacked(layout, scaled, state.q).q - state.q).norm(), 1e-14) << factor;
  }
}

TEST(RegionLayout, CountsWholeTurnsAsTheAnglesNearby) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const State state{Five(0.7, -0.4, 1.2, 9.0, -20.0), VecX::Zero(5)};
  const VecX y = Packed(layout, state);
  const VecX turned = state.q + Five(4 * kPi, 0, -2 * kPi, 0, 0);
  EXPECT_LE((Unpacked(layout, y, turned).q - turned).norm(), 1e-13);
  EXPECT_LE((Unpacked(layout, y, state.q + Five(2, 0, -2, 5, 5)).q - state.q).norm(), 1e-13);
}

// (q1 + pi, pi - q2, q3 + pi) is the same rotation, for hinges about y, x, z.
TEST(RegionLayout, TakesTheBranchNearbyUnlessLimitsKeepABallOnItsSide) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const State state{Five(0.3, 1.4, -0.2, 0, 0), Five(1, 2, 3, 0, 0)};
  const VecX other = Five(0.3 + kPi, kPi - 1.4, -0.2 + kPi, 0, 0);
  const VecX y = Packed(layout, state);
  EXPECT_LE((Unpacked(layout, y, other).q - other).norm(), 1e-13);
  // Nearer to the other one, but the middle hinge on this side of 90 degrees.
  const VecX between = Five(0.3 + 0.9 * kPi, 1.5, -0.2 + 0.9 * kPi, 0, 0);
  EXPECT_LE((Unpacked(layout, y, between).q - other).norm(), 1e-13);
  EXPECT_LE((Unpacked(layout, y, between, 100.0).q - state.q).norm(), 1e-13);
  // Whichever branch: rates of the hinges that turn the body alike.
  const State back = Unpacked(layout, y, other);
  EXPECT_LE((Packed(layout, back) - y).cwiseAbs().tail(5).maxCoeff(), 1e-12);
}

TEST(RegionLayout, ABallWithALockedHingeGoesOnAsTwoHinges) {
  RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const State state{Five(0.7, -0.4, 1.2, 0.1, 0.2), Five(2, 0, 1.5, 0, 2)};
  layout.SetLocked({0, 1, 0, 1, 0}, state.q);
  EXPECT_EQ(layout.node(1).kind, Kind::kHinges);
  EXPECT_EQ(layout.num_positions(), 3);
  EXPECT_EQ(layout.num_dofs(), 3);
  const VecX y = Packed(layout, state);
  EXPECT_EQ(y, (VecX(6) << 0.7, 1.2, 0.2, 2, 1.5, 2).finished());
  const State back = Unpacked(layout, y, VecX::Zero(5));
  EXPECT_EQ(back.q, state.q);
  EXPECT_EQ(back.qd, state.qd);
  layout.SetLocked({0, 0, 0, 0, 0}, state.q);
  EXPECT_EQ(layout.node(1).kind, Kind::kBall);
  EXPECT_EQ(layout.num_positions(), 6);
}

TEST(RegionLayout, UnpacksOneNodeAndLeavesTheOthers) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const State state{Five(0.7, -0.4, 1.2, 0.1, 0.2), Five(2, 0, 1.5, 1, 2)};
  const VecX y = Packed(layout, state), none = VecX::Constant(5, kNever);
  State part{Five(9, 9, 9, 9, 9), Five(8, 8, 8, 8, 8)};
  layout.UnpackNode(2, y.data(), -none, none, &part.q, &part.qd);
  EXPECT_EQ(part.q, Five(9, 9, 9, 0.1, 9));
  EXPECT_EQ(part.qd, Five(8, 8, 8, 1, 8));
}

TEST(RegionLayout, MeasuresHingesByTheirAnglesAndBallsByTheTurnBetweenThem) {
  const RegionLayout layout(BallAndTwoHinges(), /*balls=*/true);
  const VecX q = Five(0.7, -0.4, 1.2, 0.1, 0.2);
  const HingeTriple& ball = *layout.triple(1);
  for (const double turn : {1e-12, 1e-6, 0.3, 3.0}) {
    const Mat3 R = ball.Rotation(q.head<3>()) *
                   Mat3(Eigen::AngleAxisd(turn, Vec3(1.0, -2.0, 0.5).normalized()));
    VecX other = q + Five(0, 0, 0, -0.25, 7.0), distances;
    other.head<3>() = ball.Angles(R, q.head<3>(), false);
    layout.Distances(q, other, &distances);
    const VecX expected = Five(turn, turn, turn, 0.25, 7.0);
    EXPECT_LE((distances - expected).cwiseAbs().maxCoeff(), 1e-14 + 1e-9 * turn) << turn;
  }
  // The other branch is the same orientation.
  VecX distances;
  layout.Distances(q, q + Five(kPi, kPi + 0.8, kPi, 0, 0), &distances);
  EXPECT_LE(distances.maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace hazumi::test
