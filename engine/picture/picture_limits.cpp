#include "engine/picture/picture_limits.h"

namespace hazumi {

std::string ComplaintOnSize(std::int64_t width, std::int64_t height) {
  const bool fits = width >= 1 && height >= 1 && width <= kMostPixelsASide &&
                    height <= kMostPixelsASide && width * height <= kMostPixels;
  if (fits) return "";
  return "the picture has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; at most " + std::to_string(kMostPixelsASide) + " a side and " +
         std::to_string(kMostPixels) + " in all can be read: make it smaller";
}

}  // namespace hazumi
