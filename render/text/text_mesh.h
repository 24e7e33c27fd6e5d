#pragma once

#include <string_view>
#include <vector>

#include "render/mesh/flat_mesh.h"
#include "render/scene/marks.h"

namespace hazumi::render {

// The strokes of a line of text in pixels: the baseline starts at (0, 0), y up.
using TextStroke = std::vector<Eigen::Vector2d>;
std::vector<TextStroke> LayOutText(std::string_view utf8, double cap_height_px);

// Width from the first to the end of the last letter [px].
double TextWidth(std::string_view utf8, double cap_height_px);

// All captions of a scene, each on a dark see-through panel that keeps it legible on anything.
FlatMesh BuildCaptions(const std::vector<Caption>& captions, PictureSize size);

}  // namespace hazumi::render
