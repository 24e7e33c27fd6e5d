#pragma once

#include <cstdint>
#include <vector>

#include "render/scene/bounds.h"

namespace hazumi::render {

// How much of the sky the ground sees past the solids near it: what makes feet look planted.
// size x size texels over `rect`, rows along y, texel centres at (i + 0.5) / size;
// 255 is open sky, 0 fully covered.
struct GroundOcclusion {
  static constexpr int kSize = 64;
  GroundRect rect;
  std::vector<std::uint8_t> openness;
};

// A sphere of radius r with its centre h above the ground and at distance d from a ground point
// covers r^2 h / d^3 of that point's cosine-weighted sky (exact while it is above the horizon). A
// capsule counts as the sphere around its nearest axis point.
GroundOcclusion OccludeGround(const Scene& scene, const GroundRect& rect);

}  // namespace hazumi::render
