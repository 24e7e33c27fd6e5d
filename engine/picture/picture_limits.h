#pragma once

#include <cstdint>
#include <string>

namespace hazumi {

// The largest picture that is decoded. What comes from a stranger's file must not take all memory.
inline constexpr int kMostPixelsASide = 16384;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;    // 256 MB decoded
inline constexpr std::int64_t kMostPixelsTogether = 2 * kMostPixels;  // of the textures of a skin

// "... at most so many pixels" if a picture of this size is empty or too large; else "".
std::string ComplaintOnSize(std::int64_t width, std::int64_t height);

}  // namespace hazumi
