#pragma once

#include "engine/picture/image.h"

namespace hazumi::render {

// Half as wide and as high, at least one pixel: each is the mean of (up to) four, as displayed.
Image Halved(const Image& image);

}  // namespace hazumi::render
