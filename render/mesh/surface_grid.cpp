#include "render/mesh/surface_grid.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace hazumi::render {
namespace {

void AppendTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, SolidMesh& mesh) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

}  // namespace

std::vector<Turn> ColumnTurns(int columns) {
  std::vector<Turn> turns(columns);
  for (int i = 0; i < columns; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / columns;
    turns[i] = {std::cos(angle), std::sin(angle)};
  }
  return turns;
}

void AppendVertex(const Vec3& position, const Vec3& normal, const LinearColor& color,
                  SolidMesh& mesh) {
  const Eigen::Vector3f p = position.cast<float>(), n = normal.cast<float>();
  mesh.vertices.push_back(
      {{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}, {color.r, color.g, color.b, color.a}});
}

void JoinRings(std::uint32_t first, int rows, int columns, SolidMesh& mesh) {
  const auto around = static_cast<std::uint32_t>(columns);
  for (int row = 0; row + 1 < rows; ++row) {
    const std::uint32_t low = first + row * around, high = low + around;
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t next = (i + 1) % around;
      if (row > 0) AppendTriangle(low + i, low + next, high + i, mesh);
      if (row + 2 < rows) AppendTriangle(low + next, high + next, high + i, mesh);
    }
  }
}

void JoinPatch(std::uint32_t first, int size, SolidMesh& mesh) {
  for (int row = 0; row + 1 < size; ++row) {
    for (int i = 0; i + 1 < size; ++i) {
      const std::uint32_t low = first + row * size + i, high = low + size;
      AppendTriangle(low, low + 1, high, mesh);
      AppendTriangle(low + 1, high + 1, high, mesh);
    }
  }
}

}  // namespace hazumi::render
