#pragma once

#include <string_view>

#include "engine/picture/image.h"
#include "render/scene/color.h"

namespace hazumi::render {

// Draws a line of text into a picture, smoothed; what lies outside of it is cut off. (x, y): left
// end of the baseline, pixels from the upper left corner. `cap_height`: of capitals [px].
void DrawText(std::string_view utf8, double x, double y, double cap_height, const SrgbColor& color,
              Image* image);

// Fills whole pixels: columns x to x + width, rows y to y + height, as far as they lie in it.
void FillRectangle(int x, int y, int width, int height, const SrgbColor& color, Image* image);

// Copies a picture with its upper left corner at (x, y), as far as it lies in the other one.
void CopyInto(const Image& from, int x, int y, Image* image);

}  // namespace hazumi::render
