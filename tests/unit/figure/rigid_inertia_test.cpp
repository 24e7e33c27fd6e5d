#include "engine/spatial/rigid_inertia.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

// Sums over many points of a body: mass, mass times position, inertia about the origin.
struct PointCloud {
  double mass = 0.0;
  Vec3 moment = Vec3::Zero();
  Mat3 about_origin = Mat3::Zero();

  void Add(double m, const Vec3& p) {
    mass += m;
    moment += m * p;
    about_origin += PointInertia(m, p);
  }

  RigidInertia Sum() const {
    const Vec3 com = moment / mass;
    return {mass, com, about_origin - PointInertia(mass, com)};
  }
};

void ExpectNear(const RigidInertia& actual, const RigidInertia& expected, double tolerance) {
  EXPECT_NEAR(actual.mass, expected.mass, tolerance * expected.mass);
  EXPECT_LE((actual.com - expected.com).norm(), tolerance);
  EXPECT_LE((actual.I_com - expected.I_com).norm(), tolerance * expected.I_com.norm());
}

// A body as eight equal points, the corners of a box.
void AddAsPoints(double mass, const Vec3& com, const Mat3& axes, const Vec3& spread,
                 PointCloud* cloud) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    cloud->Add(mass / 8.0, com + axes * spread.cwiseProduct(sign));
  }
}

TEST(Combine, AgreesWithTheSumOverPoints) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    PointCloud all;
    RigidInertia combined;
    for (int i = 0; i < 5; ++i) {
      PointCloud one;
      const double mass = random.LogUniform(0.01, 100.0);
      const Vec3 com = random.Vector3(1.0), spread = random.Vector3(0.3);
      const Mat3 axes = random.Rotation();
      AddAsPoints(mass, com, axes, spread, &one);
      AddAsPoints(mass, com, axes, spread, &all);
      combined = Combine(combined, one.Sum());
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    ExpectNear(combined, all.Sum(), 1e-12);
  }
}

TEST(Combine, WithAMasslessBodyIsTheOther) {
  const RigidInertia rod = SolidCylinder({0, 0, 0}, {0, 0, 1}, 0.1, 2.0);
  ExpectNear(Combine(rod, {}), rod, 0.0);
  ExpectNear(Combine({}, rod), rod, 0.0);
  EXPECT_TRUE(Combine({}, {}).is_massless());
}

TEST(SolidCylinder, HasTheTextbookInertiaAlongEveryAxis) {
  const double m = 3.0, r = 0.2, l = 0.7;
  const double about = 0.5 * m * r * r, across = m * (3 * r * r + l * l) / 12.0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 start(0.1, 0.2, 0.3), along = l * Vec3::Unit(axis);
    Vec3 moments = Vec3::Constant(across);
    moments[axis] = about;
    ExpectNear(SolidCylinder(start, start + along, r, m),
               {m, start + 0.5 * along, moments.asDiagonal()}, 1e-14);
  }
}

TEST(SolidCylinder, TurnsWithItsEnds) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Mat3 R = random.Rotation();
    const Vec3 a = random.Vector3(1.0), b = random.Vector3(1.0);
    const RigidInertia still = SolidCylinder(a, b, 0.1, 2.0);
    ExpectNear(SolidCylinder(R * a, R * b, 0.1, 2.0),
               {2.0, R * still.com, R * still.I_com * R.transpose()}, 1e-13);
  }
}

TEST(SolidCylinder, IsTheSumOfItsSlices) {
  const Vec3 a(0.3, -0.2, 0.1), b(-0.4, 0.5, 0.2);
  RigidInertia stack;
  for (int i = 0; i < 50; ++i) {
    stack = Combine(stack, SolidCylinder(a + (b - a) * i / 50.0, a + (b - a) * (i + 1) / 50.0, 0.1,
                                         4.0 / 50.0));
  }
  ExpectNear(stack, SolidCylinder(a, b, 0.1, 4.0), 1e-13);
}

TEST(SolidCylinder, OfNoLengthIsADisc) {
  const RigidInertia disc = SolidCylinder(Vec3::Ones(), Vec3::Ones(), 0.2, 1.0);
  ExpectNear(disc, {1.0, Vec3::Ones(), Vec3(0.01, 0.01, 0.02).asDiagonal()}, 1e-14);
}

// Turned by a quarter it is the box of swapped edges.
TEST(SolidBox, IsTurned) {
  const Vec3 centre(0.1, -0.2, 0.3);
  const Mat3 quarter = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitZ()).toRotationMatrix();
  ExpectNear(SolidBox(centre, Vec3(0.5, 0.2, 0.1), 3.0, quarter),
             SolidBox(centre, Vec3(0.2, 0.5, 0.1), 3.0), 1e-15);
  const Mat3 R = Eigen::AngleAxisd(0.4, Vec3::UnitX()).toRotationMatrix() * quarter;
  const Mat3 I = SolidBox(centre, Vec3(0.5, 0.2, 0.1), 3.0, R).I_com;
  EXPECT_NEAR(R.col(1).dot(I * R.col(1)), (0.25 + 0.01), 1e-15);  // m (a^2 + c^2) / 3
}

TEST(SolidBox, IsTheSumOfItsOctants) {
  const Vec3 half(0.3, 0.2, 0.5), centre(1, 2, 3);
  RigidInertia octants;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    octants =
        Combine(octants, SolidBox(centre + 0.5 * half.cwiseProduct(sign), 0.5 * half, 6.0 / 8.0));
  }
  ExpectNear(octants, SolidBox(centre, half, 6.0), 1e-13);
}

TEST(SolidSphere, HasTwoFifths) {
  ExpectNear(SolidSphere({1, 2, 3}, 0.5, 2.0), {2.0, {1, 2, 3}, 0.2 * Mat3::Identity()}, 1e-15);
}

}  // namespace
}  // namespace hazumi::test
