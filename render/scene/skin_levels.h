#pragma once

#include "render/scene/skin_model.h"

namespace hazumi::render {

// Gives a part of the model, all of whose triangles are `indices` (vertices of `mesh`, the model's
// last one), levels with fewer triangles for small pictures. Their vertices are the mesh's own, so
// that they are posed like all others; open borders stay, so that parts do not come apart.
void AddLevels(const SkinMesh& mesh, const std::vector<std::uint32_t>& indices,
               SkinModel::Part* part, SkinModel* model);

// The one with the fewest triangles that is true to `pixels` where a metre has `pixels_per_m`.
const SkinModel::Level& LevelFor(const SkinModel::Part& part, double pixels_per_m, double pixels);

}  // namespace hazumi::render
