#pragma once

// Triangles of a skin model's meshes: their sides that are seen, and levels with fewer of them.

#include <cstdint>
#include <vector>

#include "engine/figure/skin.h"
#include "render/scene/skin_model.h"

namespace hazumi::render {

// The triangles of a mesh, as indices in threes: those whose inner side is never seen, which takes
// half the time to draw, and those that are seen from both sides, like capes and skirts of one
// layer. Triangles that are wound against their normals are turned; degenerate ones are left out.
struct SkinSurface {
  std::vector<std::uint32_t> closed, open;
};

// Decided for each connected piece of the mesh (vertices in one place are one): closed is what has
// so little border for its area (squared length over area at most 2; a square sheet has 16, a
// hemisphere 6) that its holes, at the neck or the wrists, are those where another piece goes in.
// Pieces with a vertex without normal are open. The mesh must have passed CheckSkin.
SkinSurface SplitSurface(const SkinMesh& mesh);

// Gives a part of the model, all of whose triangles are `indices` (vertices of `mesh`, the model's
// last one), levels with fewer triangles for small pictures. Their vertices are the mesh's own, so
// that they are posed like all others; open borders stay, so that parts do not come apart.
void AddLevels(const SkinMesh& mesh, const std::vector<std::uint32_t>& indices,
               SkinModel::Part* part, SkinModel* model);

// The one with the fewest triangles that is true to `pixels` where a metre has `pixels_per_m`.
const SkinModel::Level& LevelFor(const SkinModel::Part& part, double pixels_per_m, double pixels);

}  // namespace hazumi::render
