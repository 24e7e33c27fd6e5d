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

// How closely solids are looked at: what is small in the picture gets few triangles.
struct MeshDetail {
  Vec3 eye = Vec3::Zero();
  double px_per_radian = 1200.0;  // size in the picture of a small angle at its middle
};

// How far outlines may lie from where they are [px].
constexpr double kOutlineErrorPx = 0.3;

// The columns a round solid needs for its outline to be as true as that: a multiple of 4 in [8,
// 48].
int ColumnsFor(const Vec3& center, double radius_m, const MeshDetail& detail);

// Each appends one closed solid. Normals are those of the exact surface, hence smooth. `columns`, a
// multiple of 4 and at least 8, are the facets around; the other direction follows from it.
void AppendTaperedCapsule(const TaperedCapsule& capsule, int columns, SolidMesh& mesh);
void AppendEllipsoid(const Ellipsoid& ellipsoid, int columns, SolidMesh& mesh);
void AppendBox(const BoxShape& box, SolidMesh& mesh);

// Appends the scene's opaque solids, or its ghosts (colour alpha < 1).
enum class SolidKind { kOpaque, kGhost };
void AppendSolids(const Scene& scene, SolidKind kind, const MeshDetail& detail, SolidMesh& mesh);

}  // namespace hazumi::render
