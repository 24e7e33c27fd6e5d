#pragma once

#include <vector>

#include "render/mesh/flat_mesh.h"
#include "render/scene/scene.h"

namespace hazumi::render {

struct SkyVertex {
  float x, y;        // GL normalised device coordinates
  float srgb[3];
};

// Triangles over the whole picture, coloured by the elevation seen there: the horizon's colour at
// and below it, turning to the zenith's.
std::vector<SkyVertex> BuildSky(const Scene& scene, PictureSize size);

}  // namespace hazumi::render
