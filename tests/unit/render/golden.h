#pragma once

#include <string>

#include "engine/picture/image.h"

namespace hazumi::render {

// How far two pictures of one size are apart.
struct ImageDifference {
  double differing = 0.0;         // share of the pixels that differ at all
  double far_off = 0.0;           // share of the pixels off by more than 8 in a channel
  double worst_block_mean = 0.0;  // mean difference in the worst 8 x 8 block, 0..255
};
ImageDifference Compare(const Image& a, const Image& b);

// Equal, or as close as another CPU's rounding makes it (see RENDERING.md).
bool IsCloseEnough(const ImageDifference& difference);

// Compares with tests/golden/NAME.png. On failure leaves NAME.new.png, NAME.ref.png and
// NAME.diff.png in the test's temporary folder and says how to update.
// With HAZUMI_UPDATE_GOLDENS=1 in the environment it writes the golden image instead.
void ExpectMatchesGolden(const Image& image, const std::string& name);

}  // namespace hazumi::render
