#pragma once

#include "engine/figure/figure.h"
#include "engine/figure/skin.h"

namespace hazumi::render {

// What a figure of capsules looks like, as a skin for other programs: a mesh for each colour, in
// the pose of all angles zero with the root at the origin, each vertex bound to one body. Vertices
// that agree in place and normal are one. `columns`, a multiple of 4 and at least 8, are the facets
// around a capsule.
Skin SkinOfLinks(const Figure& figure, int columns = 16);

}  // namespace hazumi::render
