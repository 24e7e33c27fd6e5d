// Points R diag(h) n for unit n; the normal is along R diag(1/h) n.

#include <cmath>
#include <numbers>

#include "render/mesh/solid_mesh.h"
#include "render/mesh/surface_grid.h"

namespace hazumi::render {
namespace {

constexpr int kRings = 14;  // from pole to pole

}  // namespace

void AppendEllipsoid(const Ellipsoid& e, SolidMesh& mesh) {
  const LinearColor color = ToLinear(e.color);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Turn* turns = ColumnTurns();
  for (int ring = 0; ring < kRings; ++ring) {
    const double angle = std::numbers::pi * (1.0 - double(ring) / (kRings - 1));
    for (int i = 0; i < kColumns; ++i) {
      const Vec3 n(std::sin(angle) * turns[i].cosine, std::sin(angle) * turns[i].sine,
                   std::cos(angle));
      const Vec3 normal = (e.X_WE.R * n.cwiseQuotient(e.half_axes)).normalized();
      AppendVertex(e.X_WE * n.cwiseProduct(e.half_axes), normal, color, mesh);
    }
  }
  JoinRings(first, kRings, mesh);
}

}  // namespace hazumi::render
