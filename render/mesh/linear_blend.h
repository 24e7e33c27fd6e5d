#pragma once

#include <cstdint>
#include <vector>

#include "render/scene/skinned.h"

namespace hazumi::render {

// A vertex of a skin in a pose. Position [m] and unit normal in the world; the normal is zero where
// the skin has none to give.
struct SkinnedVertex {
  float position[3];
  float normal[3];
  std::uint8_t tint[4];  // root of linear colour times share, share
};

// Linear blend skinning: a vertex v of weights w_i, binds B_i is (sum of w_i X_WB_i inverse_bind_i)
// v, its normal that of the surface so deformed. All vertices of all meshes, in their order.
void PoseSkin(const SkinnedFigure& figure, std::vector<SkinnedVertex>* vertices);

}  // namespace hazumi::render
