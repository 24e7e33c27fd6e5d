// A box with rounded edges: the sphere of radius `bevel`, cut in eight and moved to the corners of
// the inner box. Each face is a patch of kRow^2 vertices whose middle quad is the flat face and
// whose outer quads lean to 45 degrees, where they meet the neighbouring faces.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/mesh/solid_mesh.h"
#include "render/mesh/surface_grid.h"

namespace hazumi::render {
namespace {

constexpr int kSteps = 2;  // of the rounding, per face and edge
constexpr int kRow = 2 * (kSteps + 1);

// The side of the face (-1 or 1) and the tangent of the lean there.
struct Lean {
  double side, tangent;
};

Lean LeanAt(int i) {
  const bool low = i <= kSteps;
  const int from_flat = low ? i - kSteps : i - kSteps - 1;
  return {low ? -1.0 : 1.0, std::tan(std::numbers::pi / 4.0 * from_flat / kSteps)};
}

// The face whose outward normal is +-axis `k`.
void AppendFace(const BoxShape& box, double bevel, int k, double sign, SolidMesh& mesh) {
  const LinearColor color = ToLinear(box.color);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const int u = (k + 1) % 3, v = (k + 2) % 3;
  for (int row = 0; row < kRow; ++row) {
    for (int i = 0; i < kRow; ++i) {
      const Lean lean_u = LeanAt(i), lean_v = LeanAt(row);
      Vec3 corner, n;
      corner[k] = n[k] = sign;
      corner[u] = lean_u.side * sign, n[u] = lean_u.tangent * sign;
      corner[v] = lean_v.side, n[v] = lean_v.tangent;
      n.normalize();
      const Vec3 inner = corner.cwiseProduct(Vec3(box.half_size.array() - bevel));
      AppendVertex(box.X_WB * (inner + bevel * n), box.X_WB.R * n, color, mesh);
    }
  }
  JoinPatch(first, kRow, mesh);
}

}  // namespace

void AppendBox(const BoxShape& box, SolidMesh& mesh) {
  const double bevel = std::clamp(box.bevel, 0.0, box.half_size.minCoeff());
  for (int k = 0; k < 3; ++k) {
    AppendFace(box, bevel, k, 1.0, mesh);
    AppendFace(box, bevel, k, -1.0, mesh);
  }
}

}  // namespace hazumi::render
