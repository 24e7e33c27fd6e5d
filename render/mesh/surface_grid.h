#pragma once

#include <cstdint>

#include "render/mesh/solid_mesh.h"

namespace hazumi::render {

// Columns around every lathed solid.
constexpr int kColumns = 24;

// cos and sin of the angle of a column.
struct Turn {
  double cosine, sine;
};
const Turn* ColumnTurns();

// Appends a vertex; position and normal in world coordinates.
void AppendVertex(const Vec3& position, const Vec3& normal, const LinearColor& color,
                  SolidMesh& mesh);

// Joins `rows` rings of kColumns vertices starting at `first`, whose first and last ring are single
// points (poles). Rings follow the axis; columns turn counter-clockwise about it.
void JoinRings(std::uint32_t first, int rows, SolidMesh& mesh);

// Joins a flat grid of size x size vertices starting at `first`, rows along the second axis.
void JoinPatch(std::uint32_t first, int size, SolidMesh& mesh);

}  // namespace hazumi::render
