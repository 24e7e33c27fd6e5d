#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
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

// The largest picture that is decoded. What comes from a stranger's file must not take all memory.
inline constexpr int kMostPixelsASide = 16384;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;    // 256 MB decoded
inline constexpr std::int64_t kMostPixelsTogether = 2 * kMostPixels;  // of the textures of a skin

// "... at most so many pixels" if a picture of this size is empty or too large; else "".
inline std::string ComplaintOnSize(std::int64_t width, std::int64_t height) {
  const bool fits = width >= 1 && height >= 1 && width <= kMostPixelsASide &&
                    height <= kMostPixelsASide && width * height <= kMostPixels;
  if (fits) return "";
  return "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; at most " + std::to_string(kMostPixelsASide) + " a side and " +
         std::to_string(kMostPixels) + " in all can be read: make it smaller";
}

}  // namespace hazumi
