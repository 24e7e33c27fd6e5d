#include "render/mesh/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hazumi::render {
namespace {

constexpr double kNearest = 0.05;  // [m]

bool IsOfKind(const SrgbColor& color, SolidKind kind) {
  return (color.a < 1.0f) == (kind == SolidKind::kGhost);
}

int CapsuleColumns(const TaperedCapsule& c, const MeshDetail& detail) {
  return std::max(ColumnsFor(c.a, c.radius_a, detail), ColumnsFor(c.b, c.radius_b, detail));
}

}  // namespace

void SolidMesh::Clear() {
  vertices.clear();
  indices.clear();
}

// A chord of a circle of radius r over the angle 2 pi / n leaves it by r (1 - cos(pi / n)), about
// r pi^2 / (2 n^2).
int ColumnsFor(const Vec3& center, double radius_m, const MeshDetail& detail) {
  const double distance = std::max((center - detail.eye).norm() - radius_m, kNearest);
  const double radius_px = radius_m / distance * detail.px_per_radian;
  const double needed = std::numbers::pi * std::sqrt(radius_px / (2.0 * kOutlineErrorPx));
  return std::clamp(4 * static_cast<int>(std::ceil(needed / 4.0)), 8, 48);
}

void AppendSolids(const Scene& scene, SolidKind kind, const MeshDetail& detail, SolidMesh& mesh) {
  for (const TaperedCapsule& c : scene.capsules) {
    if (IsOfKind(c.color, kind)) AppendTaperedCapsule(c, CapsuleColumns(c, detail), mesh);
  }
  for (const Ellipsoid& e : scene.ellipsoids) {
    if (!IsOfKind(e.color, kind)) continue;
    AppendEllipsoid(e, ColumnsFor(e.X_WE.p, e.half_axes.maxCoeff(), detail), mesh);
  }
  for (const BoxShape& b : scene.boxes) {
    if (IsOfKind(b.color, kind)) AppendBox(b, mesh);
  }
}

}  // namespace hazumi::render
