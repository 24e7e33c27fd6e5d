#include "engine/collision/distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace hazumi {
namespace {

constexpr double kTolerance = 1e-12;

void ExpectDistance(const Distance& d, double value, const Vec3& point, const Vec3& normal) {
  EXPECT_NEAR(d.value, value, kTolerance);
  EXPECT_LE((d.point_on_capsule - point).norm(), kTolerance) << d.point_on_capsule.transpose();
  EXPECT_LE((d.normal - normal).norm(), kTolerance) << d.normal.transpose();
}

Box UnitBox() { return {{}, Vec3(1.0, 2.0, 3.0)}; }
Capsule Sphere(const Vec3& centre, double radius) { return {centre, centre, radius}; }

TEST(PlaneDistance, IsMeasuredAtTheLowerEnd) {
  const Plane floor{Vec3::UnitZ(), 0.5};
  const Capsule c{{0, 0, 2}, {1, 0, 1}, 0.25};
  ExpectDistance(SignedDistance(c, floor), 0.25, {1, 0, 0.75}, Vec3::UnitZ());
}

TEST(PlaneDistance, CountsTheWholeDepthInASolidHalfSpace) {
  const Capsule c{{0, 0, -2}, {0, 0, 3}, 0.5};
  ExpectDistance(SignedDistance(c, Plane{}), -2.5, {0, 0, -2.5}, Vec3::UnitZ());
}

TEST(BoxDistance, FromASphereIsToTheNearestFaceEdgeOrCorner) {
  const Vec3 corner = Vec3(2, 2, 1).normalized(), edge = Vec3(3, 4, 0) / 5.0;
  ExpectDistance(SignedDistance(Sphere({3, 0, 0}, 0.5), UnitBox()), 1.5, {2.5, 0, 0},
                 Vec3::UnitX());
  ExpectDistance(SignedDistance(Sphere({4, 6, 0}, 1), UnitBox()), 4.0, Vec3(4, 6, 0) - edge, edge);
  ExpectDistance(SignedDistance(Sphere({3, 4, 4}, 1), UnitBox()), 2.0, Vec3(3, 4, 4) - corner,
                 corner);
}

TEST(BoxDistance, OfASphereInsideIsTheWayOutThroughTheNearestFace) {
  ExpectDistance(SignedDistance(Sphere({0.75, 0, 0}, 0.5), UnitBox()), -0.75, {0.25, 0, 0},
                 Vec3::UnitX());
  ExpectDistance(SignedDistance(Sphere({0, -1.9, 0}, 0.0), UnitBox()), -0.1, {0, -1.9, 0},
                 -Vec3::UnitY());
}

TEST(BoxDistance, OfASegmentAcrossAnEdgeIsAlongTheCrossProduct) {
  // x + y = 3.2 meets the edge x = 1, y = 2 only: out along (1, 1, 0) / sqrt(2), or in by 0.2 less.
  const Vec3 n = Vec3(1, 1, 0).normalized(), in = Vec3(1, 2, 0) - 0.1 * n;
  const Vec3 along = 0.5 * Vec3(1, -1, 0);
  const Capsule apart{in + 0.3 * n - along, in + 0.3 * n + along, 0.05};
  ExpectDistance(SignedDistance(apart, UnitBox()), 0.15, in + 0.25 * n, n);
  const Capsule crossing{in - along, in + along, 0.05};
  ExpectDistance(SignedDistance(crossing, UnitBox()), -0.15, in - 0.05 * n, n);
}

TEST(BoxDistance, OfASegmentThroughTheCentreIsTheLeastWayOut) {
  // Along z, and longer than the box: sideways by half_size.x. Short: no different.
  for (const double length : {0.1, 2.0, 50.0}) {
    const Capsule c{{0, 0, -length}, {0, 0, length}, 0.25};
    const Distance d = SignedDistance(c, UnitBox());
    EXPECT_NEAR(d.value, -1.25, kTolerance);
    EXPECT_NEAR(std::abs(d.normal.x()), 1.0, kTolerance);
  }
  // Along x the way out in x grows with the length, and y is 2.
  const Distance d = SignedDistance(Capsule{{-5, 0, 0}, {5, 0, 0}, 0.25}, UnitBox());
  EXPECT_NEAR(d.value, -2.25, kTolerance);
  EXPECT_NEAR(std::abs(d.normal.y()), 1.0, kTolerance);
}

TEST(BoxDistance, OfACapsuleLyingOnAFaceIsZero) {
  const Capsule c{{0.5, -1, 3.25}, {0.5, 1, 3.25}, 0.25};
  const Distance d = SignedDistance(c, UnitBox());
  EXPECT_NEAR(d.value, 0.0, kTolerance);
  EXPECT_NEAR(d.normal.z(), 1.0, kTolerance);
  EXPECT_NEAR(d.point_on_capsule.z(), 3.0, kTolerance);
}

TEST(BoxDistance, OfASegmentTouchingAFaceIsZeroAndPointsOutOfIt) {
  const Capsule c{{0, 0, 3}, {0, 0, 4}, 0.0};
  ExpectDistance(SignedDistance(c, UnitBox()), 0.0, {0, 0, 3}, Vec3::UnitZ());
}

TEST(BoxDistance, OfAPlateWithoutThicknessIsThatOfItsFace) {
  const Box plate{{}, Vec3(1, 1, 0)};
  ExpectDistance(SignedDistance(Sphere({0.2, 0, 0.3}, 0.1), plate), 0.2, {0.2, 0, 0.2},
                 Vec3::UnitZ());
  EXPECT_NEAR(SignedDistance(Capsule{{0, 0, -1}, {0, 0, 0.25}, 0.1}, plate).value, -0.35,
              kTolerance);
}

TEST(BoxDistance, TurnsWithTheWorld) {
  const Pose X_VW{AxisRotation<double>(Vec3(2, -1, 2) / 3.0, std::sin(0.7), std::cos(0.7)),
                  {5, -7, 11}};
  const Capsule c{{1.2, 2.5, -1}, {2, -1, 4}, 0.3};
  const Capsule turned{X_VW * c.a, X_VW * c.b, c.radius};
  const Distance d = SignedDistance(c, UnitBox());
  ExpectDistance(SignedDistance(turned, Box{X_VW, UnitBox().half_size}), d.value,
                 X_VW * d.point_on_capsule, X_VW.R * d.normal);
}

TEST(CapsuleDistance, OfSpheresIsBetweenTheirCentres) {
  ExpectDistance(SignedDistance(Sphere({3, 4, 0}, 1), Sphere({0, 0, 0}, 2)), 2.0, {2.4, 3.2, 0},
                 Vec3(0.6, 0.8, 0));
  EXPECT_NEAR(SignedDistance(Sphere({1, 1, 1}, 1), Sphere({1, 1, 1}, 2)).value, -3.0, kTolerance);
}

TEST(CapsuleDistance, OfSkewAxesIsAlongTheirCommonNormal) {
  const Capsule below{{-1, 0, 0}, {1, 0, 0}, 0.25}, above{{0, -1, 2}, {0, 1, 2}, 0.5};
  ExpectDistance(SignedDistance(above, below), 1.25, {0, 0, 1.5}, Vec3::UnitZ());
}

TEST(CapsuleDistance, OfCrossingAxesIsBothRadiiAlongTheirCommonNormal) {
  const Capsule a{{-1, 0, 0}, {1, 0, 0}, 0.25}, b{{0, -1, 0}, {0, 1, 0}, 0.5};
  const Distance d = SignedDistance(a, b);
  EXPECT_NEAR(d.value, -0.75, kTolerance);
  EXPECT_NEAR(std::abs(d.normal.z()), 1.0, kTolerance);
}

TEST(CapsuleDistance, OfParallelAxesIsBetweenThemOrTheirEnds) {
  const Capsule obstacle{{0, 0, 0}, {4, 0, 0}, 0.5};
  const Capsule beside{{1, 2, 0}, {9, 2, 0}, 0.5}, ahead{{5, 0, 0}, {7, 0, 0}, 0.25};
  EXPECT_NEAR(SignedDistance(beside, obstacle).value, 1.0, kTolerance);
  EXPECT_NEAR(SignedDistance(beside, obstacle).normal.y(), 1.0, kTolerance);
  ExpectDistance(SignedDistance(ahead, obstacle), 0.25, {4.75, 0, 0}, Vec3::UnitX());
}

TEST(CapsuleDistance, OfOverlappingCollinearAxesIsBothRadiiSideways) {
  const Capsule obstacle{{0, 0, 0}, {4, 0, 0}, 0.5}, c{{1, 0, 0}, {9, 0, 0}, 0.25};
  const Distance d = SignedDistance(c, obstacle);
  EXPECT_NEAR(d.value, -0.75, kTolerance);
  EXPECT_NEAR(d.normal.x(), 0.0, kTolerance);
}

// The 2x2 solve for skew lines is 1e-8 m off or worse here.
TEST(CapsuleDistance, KeepsItsDigitsForNearlyParallelAxes) {
  for (const double tilt : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Capsule a{{-50, 0, 0}, {50, 0, 0}, 0.0};
    const Capsule b{{-50, -50 * tilt, 1e-3}, {50, 50 * tilt, 1e-3}, 0.0};
    EXPECT_NEAR(SignedDistance(a, b).value, 1e-3, kTolerance) << tilt;
  }
}

TEST(ObstacleDistance, IsThatOfTheShapeItHolds) {
  const Capsule c{{1.2, 2.5, -1}, {2, -1, 4}, 0.3}, other{{0, 0, 0}, {0, 1, 0}, 0.1};
  EXPECT_EQ(SignedDistance(c, Obstacle(Plane{})).value, SignedDistance(c, Plane{}).value);
  EXPECT_EQ(SignedDistance(c, Obstacle(UnitBox())).value, SignedDistance(c, UnitBox()).value);
  EXPECT_EQ(SignedDistance(c, Obstacle(other)).value, SignedDistance(c, other).value);
}

}  // namespace
}  // namespace hazumi
