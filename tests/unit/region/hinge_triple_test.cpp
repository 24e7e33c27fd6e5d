#include "engine/region/hinge_triple.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hazumi {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr bool kKeepsSide = true;

// The poles are at 90 degrees of the middle hinge. What the triple turns passes one at a distance
// of `off` while x goes from below zero to above [rad].
struct PastThePole {
  double off;
  const HingeTriple triple{Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()};

  Mat3 At(double x) const {
    const Mat3 at_pole = triple.Rotation({0.0, 0.5 * kPi, 0.0});
    return Mat3(Eigen::AngleAxisd(x, Vec3::UnitX()) * Eigen::AngleAxisd(off, Vec3::UnitZ())) *
           at_pole;
  }

  // The angles at 0.3, followed from -0.3 on.
  Vec3 Follow(bool keeps_side) const {
    Vec3 q = triple.Angles(At(-0.3), Vec3(0.0, 0.5 * kPi - 0.3, 0.0), keeps_side);
    for (int i = -300; i < 300; ++i) q = triple.Angles(At(1e-3 * (i + 0.5)), q, keeps_side);
    return triple.Angles(At(0.3), q, keeps_side);
  }
};

TEST(HingeTriple, TurnsOuterHingesByHalfATurnPastAPoleIfItKeepsItsSide) {
  for (const double off : {-0.02, 0.02}) {
    const PastThePole path{off};
    const Vec3 q = path.Follow(kKeepsSide);
    EXPECT_LT(q[1], 0.5 * kPi);
    EXPECT_NEAR(std::abs(q[0]), kPi, 0.1);
    EXPECT_NEAR(std::abs(q[2]), kPi, 0.1);
    EXPECT_LE((path.triple.Rotation(q) - path.At(0.3)).norm(), 1e-14);
  }
}

TEST(HingeTriple, GoesOnWithTheMiddleHingePastAPoleOtherwise) {
  const PastThePole path{1e-4};
  const Vec3 q = path.Follow(!kKeepsSide);
  EXPECT_NEAR(q[1], 0.5 * kPi + 0.3, 1e-3);
  EXPECT_NEAR(q[0], 0.0, 1e-3);
  EXPECT_LE((path.triple.Rotation(q) - path.At(0.3)).norm(), 1e-14);
}

TEST(HingeTriple, IsOnTheOtherSideOnceThroughAPole) {
  const PastThePole path{0.0};
  const Vec3 before(0.0, 0.5 * kPi - 0.3, 0.0);
  const Vec3 through = path.triple.ThroughPole(path.At(-1e-8), before);
  const Vec3 q = path.triple.Angles(path.At(0.3), through, kKeepsSide);
  EXPECT_NEAR(q[0], 0.0, 1e-12);
  EXPECT_NEAR(q[1], 0.5 * kPi + 0.3, 1e-12);
  EXPECT_NEAR(q[2], 0.0, 1e-12);
}

TEST(HingeTriple, ApproachesAPoleUntilItIsPassed) {
  const HingeTriple& triple = PastThePole{0.0}.triple;
  for (const double from : {-0.5 * kPi, 0.5 * kPi}) {
    EXPECT_GT(triple.Approach(Vec3(0.2, from - 0.1, 0.3), Vec3(5.0, 1.0, -2.0)), 0.0);
    EXPECT_LT(triple.Approach(Vec3(0.2, from + 0.1, 0.3), Vec3(5.0, 1.0, -2.0)), 0.0);
  }
}

}  // namespace
}  // namespace hazumi
