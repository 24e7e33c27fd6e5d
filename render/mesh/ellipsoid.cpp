// Points R diag(h) n for unit n; the normal is along R diag(1/h) n.

#include <cmath>
#include <numbers>

#include "render/mesh/solid_mesh.h"
#include "render/mesh/surface_grid.h"

namespace hazumi::render {

void AppendEllipsoid(const Ellipsoid& e, int columns, SolidMesh& mesh) {
  const LinearColor color = ToLinear(e.color);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<Turn> turns = ColumnTurns(columns);
  const int steps = columns / 2;
  for (int ring = 0; ring <= steps; ++ring) {
    const double angle = std::numbers::pi * (1.0 - double(ring) / steps);
    for (const Turn& turn : turns) {
      const Vec3 n(std::sin(angle) * turn.cosine, std::sin(angle) * turn.sine, std::cos(angle));
      const Vec3 normal = (e.X_WE.R * n.cwiseQuotient(e.half_axes)).normalized();
      AppendVertex(e.X_WE * n.cwiseProduct(e.half_axes), normal, color, mesh);
    }
  }
  JoinRings(first, steps + 1, columns, mesh);
}

}  // namespace hazumi::render
