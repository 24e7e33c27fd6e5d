#pragma once

#include <cstdint>
#include <vector>

#include "render/mesh/solid_mesh.h"

namespace hazumi::render {

// cos and sin of the angle of each of `columns` columns around an axis.
struct Turn {
  double cosine, sine;
};
std::vector<Turn> ColumnTurns(int columns);

// Appends a vertex; position and normal in world coordinates.
void AppendVertex(const Vec3& position, const Vec3& normal, const LinearColor& color,
                  SolidMesh& mesh);

// Joins `rows` rings of `columns` vertices starting at `first`, whose first and last ring are
// single points (poles). Rings follow the axis; columns turn counter-clockwise about it.
void JoinRings(std::uint32_t first, int rows, int columns, SolidMesh& mesh);

// Joins a flat grid of size x size vertices starting at `first`, rows along the second axis.
void JoinPatch(std::uint32_t first, int size, SolidMesh& mesh);

}  // namespace hazumi::render
