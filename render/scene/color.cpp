#include "render/scene/color.h"

#include <algorithm>
#include <cmath>

namespace hazumi::render {
namespace {

// IEC 61966-2-1.
float Decode(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

float Encode(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

LinearColor ToLinear(const SrgbColor& color) {
  return {Decode(color.r), Decode(color.g), Decode(color.b), color.a};
}

SrgbColor ToSrgb(const LinearColor& color) {
  return {Encode(color.r), Encode(color.g), Encode(color.b), color.a};
}

}  // namespace hazumi::render
