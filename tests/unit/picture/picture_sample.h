#pragma once

// Pictures of known content, as files.

#include <cstdint>
#include <cstdio>
// jpeglib.h needs the declarations of stdio.
#include <jpeglib.h>

#include <vector>

#include "engine/picture/image.h"

namespace hazumi::test {

using Bytes = std::vector<std::uint8_t>;

// Red above, blue below.
Image TwoColors(int size);

Bytes PngOf(const Image& image);

enum class Scans { kOne, kProgressive };
Bytes JpegOf(const Image& image, Scans scans = Scans::kOne, J_COLOR_SPACE space = JCS_EXT_RGBA);

}  // namespace hazumi::test
