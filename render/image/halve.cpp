#include "render/image/halve.h"

#include <algorithm>

namespace hazumi::render {

Image Halved(const Image& image) {
  Image half(std::max(image.width / 2, 1), std::max(image.height / 2, 1));
  const auto at = [&](int x, int y) {
    x = std::min(x, image.width - 1), y = std::min(y, image.height - 1);
    return &image.rgba[4 * (static_cast<size_t>(y) * image.width + x)];
  };
  std::uint8_t* to = half.rgba.data();
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const std::uint8_t* four[] = {at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1),
                                    at(2 * x + 1, 2 * y + 1)};
      for (int k = 0; k < 4; ++k) {
        *to++ =
            static_cast<std::uint8_t>((four[0][k] + four[1][k] + four[2][k] + four[3][k] + 2) / 4);
      }
    }
  }
  return half;
}

}  // namespace hazumi::render
