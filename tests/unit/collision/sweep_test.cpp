#include <gtest/gtest.h>

#include <cmath>

#include "engine/collision/distance.h"

namespace hazumi {
namespace {

Capsule SweptSphere(const Vec3& centre, double radius) { return {centre, centre, radius}; }

void ExpectTouch(const std::optional<double>& s, double expected, double tolerance = 1e-10) {
  ASSERT_TRUE(s.has_value());
  EXPECT_NEAR(*s, expected, tolerance);
}

TEST(FirstTouch, OfASphereFallingOnAFloorIsWhenItsBottomIsThere) {
  ExpectTouch(FirstTouch(SweptSphere({0, 0, 2}, 0.5), {1, 0, -3}, Plane{}), 0.5);
}

TEST(FirstTouch, OfASphereFlyingAtASphereSolvesTheQuadratic) {
  // Centres 3 apart sideways, 5 radii in all: 4 before abreast.
  ExpectTouch(FirstTouch(SweptSphere({-10, 3, 0}, 2), {20, 0, 0}, SweptSphere({0, 0, 0}, 3)), 0.3);
}

TEST(FirstTouch, OfASphereFlyingAtABoxCornerSolvesTheQuadratic) {
  const Box box{{}, Vec3(1, 1, 1)};
  const double x = 1.0 + std::sqrt(1.0 - 0.36 - 0.25);
  ExpectTouch(FirstTouch(SweptSphere({5, 1.6, 1.5}, 1), {-10, 0, 0}, box), (5.0 - x) / 10.0);
}

TEST(FirstTouch, OfCrossedCapsulesIsWhenTheirSidesMeet) {
  const Capsule below{{-1, 0, 0}, {1, 0, 0}, 0.25}, above{{0, -1, 2}, {0, 1, 2}, 0.5};
  ExpectTouch(FirstTouch(above, {0, 0, -5}, below), 0.25);
}

TEST(FirstTouch, CannotTunnelThroughAThinPlate) {
  const Box plate{{}, Vec3(0.5, 0.5, 0.0025)};
  const Capsule fist{{0, 0, 3}, {0.1, 0, 3}, 0.04};
  for (const double speed : {4.0, 30.0, 1e3, 1e5})
    ExpectTouch(FirstTouch(fist, {0, 0, -speed}, plate), (3.0 - 0.0425) / speed);
  const Capsule needle{{0, 0, 3}, {0, 0, 3.001}, 0.0};
  ExpectTouch(FirstTouch(needle, {0, 0, -30}, plate), (3.0 - 0.0025) / 30.0);
}

TEST(FirstTouch, IsZeroWhenTouchingOrOverlappingAtTheStart) {
  const Box box{{}, Vec3(1, 1, 1)};
  for (const double z : {1.5, 1.25, 0.0})
    for (const Vec3& path : {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 0, 0)})
      EXPECT_EQ(FirstTouch(SweptSphere({0, 0, z}, 0.5), path, box), 0.0);
}

TEST(FirstTouch, IsNoneWithoutAPathOrOnTheWayOutOrShort) {
  const Box box{{}, Vec3(1, 1, 1)};
  const Capsule c = SweptSphere({0, 0, 2}, 0.5);
  EXPECT_FALSE(FirstTouch(c, {0, 0, 0}, box));
  EXPECT_FALSE(FirstTouch(c, {0, 0, 100}, box));
  EXPECT_FALSE(FirstTouch(c, {0, 0, -0.499}, box));
  EXPECT_FALSE(FirstTouch(c, {100, 0, 0}, box));
  ExpectTouch(FirstTouch(c, {0, 0, -0.5}, box), 1.0);
}

TEST(FirstTouch, AlongAFaceIsTheEdgeItRunsInto) {
  const Box box{{}, Vec3(1, 1, 1)};
  const double gap = 1e-9;
  EXPECT_FALSE(FirstTouch(SweptSphere({-5, 0, 1.5 + gap}, 0.5), {10, 0, 0}, box));
  ExpectTouch(FirstTouch(SweptSphere({-5, 0, 1.5 - gap}, 0.5), {10, 0, 0}, box),
              (4.0 - std::sqrt(gap)) / 10.0, 1e-8);
}

// Tangential: the gap falls to +-1e-9 m as the square of the way, from either side of touching.
TEST(FirstTouch, DecidesAGrazingPathToANanometre) {
  const Capsule obstacle = SweptSphere({0, 0, 0}, 1.0);
  for (const double speed : {1.0, 10.0, 1e4}) {
    const Vec3 path(2.0 * speed, 0, 0);
    const auto fly = [&](double height) {
      return FirstTouch(SweptSphere({-speed, 0, height}, 0.5), path, obstacle);
    };
    EXPECT_FALSE(fly(1.5 + 1e-9)) << speed;
    EXPECT_TRUE(fly(1.5 - 1e-9)) << speed;
    if (const auto s = fly(1.5)) {
      EXPECT_NEAR((*s - 0.5) * 2.0 * speed, 0.0, 1e-5);
    }
  }
}

// Too near, for too long, for Newton's steps: the search decides.
TEST(FirstTouch, DecidesALongGlideToANanometre) {
  const Box runway{{}, Vec3(60, 60, 1)};
  const Capsule c{{-50, -1, 1.5 + 1e-6}, {-50, 1, 1.5 + 1e-6}, 0.5};
  EXPECT_FALSE(FirstTouch(c, {100, 0, 0}, runway));
  EXPECT_FALSE(FirstTouch(c, {100, 0, -0.999e-6}, runway));
  ExpectTouch(FirstTouch(c, {100, 0, -1e-6}, runway), 1.0, 2e-5);
  ExpectTouch(FirstTouch(c, {100, 0, -2e-6}, runway), 0.5, 1e-5);
}

TEST(FirstTouch, GivesTheSameBitsTwice) {
  const Capsule c{{0.1, -4, 2}, {0.7, -3, 1}, 0.2};
  const Box box{{}, Vec3(0.3, 1, 0.9)};
  const auto first = FirstTouch(c, {0, 4, -1}, box);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first, FirstTouch(c, {0, 4, -1}, box));
}

}  // namespace
}  // namespace hazumi
