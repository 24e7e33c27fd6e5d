// A thin rod that stands on one end on rough ground, let go, beside the law of its fall: up to
// where its foot slips, and which way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/spatial/degrees.h"
#include "tests/support/compare.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kMostLate = 1e-3;  // how far it turns at most until its foot is seen to slip [rad]
constexpr double kRodHalf = 0.4, kRodRadius = 1e-4, kLetGo = 0.1;  // [m, m, rad from upright]

// How hard the foot pushes along the ground and onto it while it stays, as parts of the weight, for
// a rod that turns about its foot with w^2 = 3 g (cos q0 - cos q) / L: with q0 = 0
//   3 sin q (3 cos q - 2) / 4  and  (1 - 3 cos q)^2 / 4.
struct FootPush {
  double along, onto;
};
FootPush PushAt(double angle, double let_go) {
  const double c = std::cos(angle), c0 = std::cos(let_go);
  return {0.75 * std::sin(angle) * (3.0 * c - 2.0 * c0), 0.25 * (1.0 + 9.0 * c * c - 6.0 * c * c0)};
}

// Where it slips [rad from upright].
double SlipAngle(double friction) {
  double angle = kLetGo;
  const auto slips = [friction](double at) {
    const FootPush push = PushAt(at, kLetGo);
    return std::abs(push.along) > friction * push.onto;
  };
  while (!slips(angle)) angle += 1e-6;
  return angle;
}

// Leaning towards +x.
Animation Leaning(double friction) {
  Animation animation = Loose(FreeCapsule(kRodHalf, kRodRadius), 30);
  AddIncline(&animation, 0.0, friction);
  animation.root_keys[kRootAngleY] = {{0, kLetGo - M_PI / 2.0, 0.0, kHold}};
  SetRootAt(&animation,
            Vec3(kRodHalf * std::sin(kLetGo), 0.0, kRodRadius + kRodHalf * std::cos(kLetGo)));
  return animation;
}

struct RodState {
  double angle, rate;  // from upright [rad, rad/s]
  double slip;         // velocity of what touches the ground [m/s]
};
RodState StateOf(const MotionFrame& frame) {
  const Vec3 axis = frame.X_WR.R.col(0);  // from the foot up
  const Vec3 w = frame.after.root_w;
  const Vec3 foot = frame.after.root_v - w.cross(kRodHalf * axis);
  return {std::atan2(axis.x(), axis.z()), w.y(), foot.x() - kRodRadius * w.y()};
}

Vec3 SumOfPushes(const MotionFrame& frame) {
  Vec3 sum = Vec3::Zero();
  for (const ContactPush& push : frame.contacts.pushes) sum += push.force;
  return sum;
}

// Below 35.1 degrees, and backwards, where the coefficient is less than 0.37; else beyond 48.2
// degrees, where it has to be held back, and forwards.
TEST(RodSlip, ARodOnRoughGroundTurnsAboutItsFootUntilItSlips) {
  for (const double friction : {0.2, 0.3, 0.36, 0.5, 0.8}) {
    const double expected = SlipAngle(friction), weight = kMass * kG;
    EXPECT_EQ(expected < 35.1 * kDegree, friction < 0.3706) << friction;
    BakeOptions fine;
    fine.output_rate = FrameRate{3000, 1};
    const Motion motion = BakeOrFail(Leaning(friction), fine);
    double slipped = 0.0, way = 0.0, before = kLetGo;
    Worst rate("log10 of the error of the square of the rate, as a part of g / L"),
        push("log10 of the error of the foot's push, as a part of the weight");
    for (const MotionFrame& frame : motion.frames) {
      const RodState rod = StateOf(frame);
      if (std::abs(rod.slip) > 1e-9) {
        slipped = 0.5 * (before + rod.angle);
        way = rod.slip;
        break;
      }
      const double square = 1.5 * kG / kRodHalf * (std::cos(kLetGo) - std::cos(rod.angle));
      rate(std::abs(rod.rate * rod.rate - square) / (0.5 * kG / kRodHalf));
      const FootPush law = PushAt(rod.angle, kLetGo);
      before = rod.angle;
      push((SumOfPushes(frame) / weight - Vec3(law.along, 0.0, law.onto)).norm());
    }
    std::printf(
        "  friction %.2f: slips at %.4f degrees, by the law at %.4f; rate %.1g, push %.1g\n",
        friction, slipped / kDegree, expected / kDegree, rate.value(), push.value());
    EXPECT_NEAR(slipped, expected, kMostLate) << friction;
    EXPECT_EQ(way < 0.0, friction < 0.3706) << friction;
    EXPECT_LT(rate.value(), 1e-3) << friction;
    EXPECT_LT(push.value(), 1e-3) << friction;
  }
}

// With the inertia that it has, and on a foot so small, by the law of a thin rod on smooth ground:
//   w^2 = 12 g (cos q0 - cos q) / (L (1 + 3 sin^2 q)).
TEST(RodSlip, AThinRodOnSmoothGroundFallsByTheLawOfAThinRod) {
  const Motion motion = BakeOrFail(Leaning(0.0));
  Worst rate("log10 of the error of the rate [rad/s]");
  int falling = 0;
  for (const MotionFrame& frame : motion.frames) {
    const RodState rod = StateOf(frame);
    if (rod.angle > 85.0 * kDegree) break;
    const double sine = std::sin(rod.angle);
    const double square = 12.0 * kG * (std::cos(kLetGo) - std::cos(rod.angle)) /
                          (2.0 * kRodHalf * (1.0 + 3.0 * sine * sine));
    EXPECT_LT(rate(std::abs(rod.rate - std::sqrt(std::max(0.0, square)))), 1e-5) << frame.frame;
    ++falling;
  }
  EXPECT_GT(falling, 15);
  std::printf("  largest error of the rate: %.1g rad/s\n", rate.value());
}

}  // namespace
}  // namespace hazumi::test
