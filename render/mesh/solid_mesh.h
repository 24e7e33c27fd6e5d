#pragma once

#include <cstdint>
#include <vector>

#include "render/scene/scene.h"

namespace hazumi::render {

// A point of a solid's surface in world coordinates [m] with its outward unit normal.
struct SolidVertex {
  float position[3];
  float normal[3];
  float linear_rgba[4];
};

// Triangles of many solids, counter-clockwise from outside.
struct SolidMesh {
  std::vector<SolidVertex> vertices;
  std::vector<std::uint32_t> indices;

  void Clear();
};

// Each appends one closed solid. Normals are those of the exact surface, hence smooth.
void AppendTaperedCapsule(const TaperedCapsule& capsule, SolidMesh& mesh);
void AppendEllipsoid(const Ellipsoid& ellipsoid, SolidMesh& mesh);
void AppendBox(const BoxShape& box, SolidMesh& mesh);

// Appends the scene's opaque solids, or its ghosts (colour alpha < 1).
enum class SolidKind { kOpaque, kGhost };
void AppendSolids(const Scene& scene, SolidKind kind, SolidMesh& mesh);

}  // namespace hazumi::render
