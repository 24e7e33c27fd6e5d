// What air does to a surface: published figures, and where coefficients come from.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/region/forces/wind.h"
#include "engine/spatial/degrees.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

using std::numbers::pi;

constexpr double kAir = 1.225;

LinkSurface Of(LinkSurface::Kind kind, double area = 0.05) {
  LinkSurface surface;
  surface.kind = kind;
  surface.area = area;
  return surface;
}

// Two wings that sweep to and fro at 45 degrees, each turned over where it turns back:
//   rho C_L S (r_2 R)^2 (pi f Phi)^2 / 2 = 25.6 mN.
TEST(AirOnSurface, CarriesWhatBeatsItsWings) {
  constexpr double kBeat = 42.0, kStroke = 120.0 * kDegree, kRadius = 0.5 * 0.047;
  const LinkSurface wing = Of(LinkSurface::Kind::kWing, 5.5e-4);
  constexpr int kSamples = 1000;
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double phase = 2.0 * pi * (i + 0.5) / kSamples;
    const double v = kRadius * 0.5 * kStroke * 2.0 * pi * kBeat * std::cos(phase);
    const Vec3 n = Vec3(v > 0.0 ? -1.0 : 1.0, 0.0, 1.0).normalized();
    sum += AirOnSurface(wing, kAir, n, -v * Vec3::UnitX()).z();
  }
  const double lift = 2.0 * sum / kSamples;
  RecordProperty("mN", std::to_string(1e3 * lift));
  EXPECT_NEAR(lift, 25.6e-3, 0.005 * 25.6e-3);
  const double C_L = 0.225 + 1.58 * std::sin((2.13 * 45.0 - 7.2) * kDegree);
  const double expected = kAir * C_L * wing.area * std::pow(kRadius * pi * kBeat * kStroke, 2) / 2;
  EXPECT_NEAR(lift, expected, 1e-12);
}

TEST(AirOnSurface, HasNoLiftAlongItNorAcrossIt) {
  LinkSurface table = Of(LinkSurface::Kind::kTable);
  table.lift = {0.5, 1.0, 0.7};
  table.drag = {0.1, 1.0, 2.0};
  for (const LinkSurface& surface :
       {Of(LinkSurface::Kind::kWing), Of(LinkSurface::Kind::kPlate), table}) {
    EXPECT_EQ(CoefficientsOf(surface, 0.0).lift, 0.0);
    EXPECT_EQ(CoefficientsOf(surface, 0.5 * pi).lift, 0.0);
    double before = 0.0;
    for (double angle = 0.0; angle <= 90.0; angle += 0.01) {  // without a step
      const double lift = CoefficientsOf(surface, angle * kDegree).lift;
      EXPECT_LT(std::abs(lift - before), 0.01) << angle;
      before = lift;
    }
  }
}

TEST(AirOnSurface, ATableIsReadBetweenItsValues) {
  LinkSurface table = Of(LinkSurface::Kind::kTable);
  table.lift = {0.0, 1.0, 0.0};
  table.drag = {0.1, 1.0, 3.0};
  EXPECT_NEAR(CoefficientsOf(table, 22.5 * kDegree).lift, 0.5, 1e-12);
  EXPECT_NEAR(CoefficientsOf(table, 67.5 * kDegree).drag, 2.0, 1e-12);
  EXPECT_NEAR(CoefficientsOf(table, 90.0 * kDegree).drag, 3.0, 1e-12);
  table.drag = {3.461};
  for (const double angle : {0.0, 0.4, 1.2}) {
    EXPECT_EQ(CoefficientsOf(table, angle).drag, 3.461);
  }
}

// A plate is pushed along its normal, away from where the wind comes from.
TEST(AirOnSurface, OfAPlateIsAlongItsNormal) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 n = random.Vector3(1.0).normalized(), u = random.Vector3(4.0);
    const double sine = std::abs(n.dot(u)) / u.norm();
    const double angle = std::asin(sine) / kDegree;
    if (angle < 5.0 || angle > 85.0) continue;
    const Vec3 force = AirOnSurface(Of(LinkSurface::Kind::kPlate), kAir, n, u);
    const double size = 0.5 * kAir * 0.05 * u.squaredNorm() * 1.17 * sine;
    EXPECT_LT((force - (n.dot(u) < 0.0 ? -size : size) * n).norm(), 1e-12 * (1.0 + size));
  }
}

// Plate of solver version 2, whose lift is not faded next to 0 and 90 degrees.
TEST(AirOnSurface, UnfadedPlate_HasAForceAlongItsNormalAtAllAngles) {
  LinkSurface plate = Of(LinkSurface::Kind::kPlate);
  plate.is_faded = false;
  for (const double angle : {0.1, 1.0, 4.0, 45.0, 88.0, 89.9}) {
    const AirCoefficients found = CoefficientsOf(plate, angle * kDegree);
    const double s = std::sin(angle * kDegree), c = std::cos(angle * kDegree);
    EXPECT_NEAR(found.lift, 1.17 * s * c, 1e-15) << angle;
    EXPECT_NEAR(found.drag, 1.17 * s * s, 1e-15) << angle;
  }
}

}  // namespace
}  // namespace hazumi::test
