#pragma once

#include <vector>

#include "render/mesh/flat_mesh.h"
#include "render/scene/scene.h"

namespace hazumi::render {

struct SkyVertex {
  float x, y;  // GL normalised device coordinates
  float srgb[3];
};

// Triangles over all of the picture that is above the horizon, coloured by the elevation seen
// there, from the horizon's colour to the zenith's. Below, the picture must be cleared to the
// horizon's.
std::vector<SkyVertex> BuildSky(const Scene& scene, PictureSize size);

}  // namespace hazumi::render
