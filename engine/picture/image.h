#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hazumi {

// A picture in memory: 4 bytes a pixel (sRGB-encoded red, green, blue; the fourth is alpha in
// what was decoded and ignored in what is written), rows from the top without gaps.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int w, int h) : width(w), height(h), rgba(std::size_t(w) * std::size_t(h) * 4) {}
};

}  // namespace hazumi
