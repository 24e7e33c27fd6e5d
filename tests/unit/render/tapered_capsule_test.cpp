#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/mesh/solid_mesh.h"

namespace hazumi::render {
namespace {

Vec3 PositionOf(const SolidVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }
Vec3 NormalOf(const SolidVertex& v) { return {v.normal[0], v.normal[1], v.normal[2]}; }

SolidMesh MeshOf(const TaperedCapsule& capsule) {
  SolidMesh mesh;
  AppendTaperedCapsule(capsule, 24, mesh);
  return mesh;
}

// Signed distance to the union of all spheres between (a, ra) and (b, rb), by a fine search: an
// oracle that knows nothing of tangent cones.
double DistanceBySearch(const TaperedCapsule& c, const Vec3& p) {
  double least = 1e30;
  for (int i = 0; i <= 20000; ++i) {
    const double t = i / 20000.0;
    const Vec3 center = c.a + t * (c.b - c.a);
    least = std::min(least, (p - center).norm() - std::lerp(c.radius_a, c.radius_b, t));
  }
  return least;
}

void ExpectOnSurface(const TaperedCapsule& c) {
  const SolidMesh mesh = MeshOf(c);
  for (size_t i = 0; i < mesh.vertices.size(); i += 7) {
    EXPECT_NEAR(DistanceBySearch(c, PositionOf(mesh.vertices[i])), 0.0, 2e-6);
    EXPECT_NEAR(NormalOf(mesh.vertices[i]).norm(), 1.0, 1e-6);
  }
}

double SignedVolume(const SolidMesh& mesh) {
  double volume = 0.0;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vec3 a = PositionOf(mesh.vertices[mesh.indices[i]]);
    const Vec3 b = PositionOf(mesh.vertices[mesh.indices[i + 1]]);
    const Vec3 c = PositionOf(mesh.vertices[mesh.indices[i + 2]]);
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

TEST(TaperedCapsuleMesh, PointsLieOnTheHullOfTheTwoSpheres) {
  ExpectOnSurface({{0.1, -0.2, 0.3}, {0.4, 0.3, 0.9}, 0.12, 0.05, {}});
  ExpectOnSurface({{0.0, 0.0, 1.0}, {0.0, 0.0, 0.2}, 0.03, 0.2, {}});
  ExpectOnSurface({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.1, 0.1, {}});
}

TEST(TaperedCapsuleMesh, NormalsOfTheConeAreSquareToItsLines) {
  const TaperedCapsule c{{0, 0, 0}, {0, 0, 1}, 0.3, 0.1, {}};
  const SolidMesh mesh = MeshOf(c);
  const int columns = 24, steps = columns / 4;
  for (int i = 0; i < columns; ++i) {
    const SolidVertex& low = mesh.vertices[steps * columns + i];
    const SolidVertex& high = mesh.vertices[(steps + 1) * columns + i];
    EXPECT_NEAR((PositionOf(high) - PositionOf(low)).dot(NormalOf(low)), 0.0, 1e-6);
    EXPECT_NEAR((NormalOf(high) - NormalOf(low)).norm(), 0.0, 1e-6);
  }
}

TEST(TaperedCapsuleMesh, IsTheLargerSphereWhenThatHoldsTheOther) {
  const TaperedCapsule inside_a{{1, 2, 3}, {1.05, 2, 3}, 0.2, 0.1, {}};
  const TaperedCapsule inside_b{{1.05, 2, 3}, {1, 2, 3}, 0.1, 0.2, {}};
  for (const TaperedCapsule& c : {inside_a, inside_b}) {
    for (const SolidVertex& v : MeshOf(c).vertices) {
      EXPECT_NEAR((PositionOf(v) - Vec3(1, 2, 3)).norm(), 0.2, 1e-6);
    }
  }
}

TEST(TaperedCapsuleMesh, CoincidingEndsAndPointsGiveNoNan) {
  const TaperedCapsule cases[] = {{{1, 1, 1}, {1, 1, 1}, 0.1, 0.1, {}},
                                  {{1, 1, 1}, {1, 1, 1}, 0.0, 0.0, {}},
                                  {{1, 1, 1}, {1, 1, 2}, 0.0, 0.0, {}},
                                  {{0, 0, 0}, {0, 0, 0.1}, 0.2, 0.1, {}}};
  for (const TaperedCapsule& c : cases) {
    for (const SolidVertex& v : MeshOf(c).vertices) {
      EXPECT_TRUE(PositionOf(v).allFinite());
      EXPECT_NEAR(NormalOf(v).norm(), 1.0, 1e-6);
    }
  }
}

// The exact volume of the two caps and the frustum between them; the mesh has flat facets.
TEST(TaperedCapsuleMesh, IsClosedAndFacesOutward) {
  const TaperedCapsule c{{0, 0, 0}, {0, 0, 1}, 0.1, 0.1, {}};
  SolidMesh mesh;
  AppendTaperedCapsule(c, 48, mesh);
  const double exact = M_PI * 0.01 * (1.0 + 4.0 / 3.0 * 0.1);
  EXPECT_NEAR(SignedVolume(mesh), exact, 0.01 * exact);
}

TEST(EllipsoidMesh, PointsAndNormalsAreThoseOfTheEllipsoid) {
  const Vec3 half(0.1, 0.2, 0.3);
  SolidMesh mesh;
  AppendEllipsoid({{Mat3::Identity(), Vec3::Zero()}, half, {}}, 24, mesh);
  for (const SolidVertex& v : mesh.vertices) {
    const Vec3 p = PositionOf(v);
    EXPECT_NEAR(p.cwiseQuotient(half).norm(), 1.0, 1e-6);
    const Vec3 gradient = p.cwiseQuotient(half.cwiseProduct(half)).normalized();
    EXPECT_NEAR(gradient.dot(NormalOf(v)), 1.0, 1e-6);
  }
  const double exact = 4.0 / 3.0 * M_PI * half.prod();
  EXPECT_NEAR(SignedVolume(mesh), exact, 0.05 * exact);
}

TEST(BoxMesh, HasTheBoxesExtentAndFacesOutward) {
  SolidMesh mesh;
  AppendBox({{Mat3::Identity(), {1, 1, 1}}, {0.5, 0.4, 0.3}, 0.02, {}}, mesh);
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const SolidVertex& v : mesh.vertices) {
    low = low.cwiseMin(PositionOf(v)), high = high.cwiseMax(PositionOf(v));
  }
  EXPECT_NEAR((high - Vec3(1.5, 1.4, 1.3)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((low - Vec3(0.5, 0.6, 0.7)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(SignedVolume(mesh), 0.48, 0.002);
}

TEST(MeshDetail, OutlinesAreTrueToAThirdOfAPixel) {
  const MeshDetail detail{{0, 0, 0}, 1000.0};
  for (const double radius : {0.02, 0.05, 0.1, 0.3}) {
    const int n = ColumnsFor({3, 0, 0}, radius, detail);
    const double radius_px = radius / (3.0 - radius) * 1000.0;
    EXPECT_EQ(n % 4, 0);
    EXPECT_LE(radius_px * (1.0 - std::cos(M_PI / n)), 0.3);
  }
}

}  // namespace
}  // namespace hazumi::render
