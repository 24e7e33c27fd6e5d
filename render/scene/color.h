#pragma once

#include <cstdint>

namespace hazumi::render {

// A colour as it is displayed and as #rrggbb writes it: sRGB-encoded components and a linear alpha
// (coverage), all in [0, 1].
struct SrgbColor {
  float r = 0.0f, g = 0.0f, b = 0.0f, a = 1.0f;
  friend bool operator==(const SrgbColor&, const SrgbColor&) = default;
};

// The same colour with components proportional to light, for shading.
struct LinearColor {
  float r = 0.0f, g = 0.0f, b = 0.0f, a = 1.0f;
};

// FromHex(0xffbe33) is #ffbe33.
constexpr SrgbColor FromHex(std::uint32_t rrggbb, float alpha = 1.0f) {
  return {static_cast<float>((rrggbb >> 16) & 0xff) / 255.0f,
          static_cast<float>((rrggbb >> 8) & 0xff) / 255.0f,
          static_cast<float>(rrggbb & 0xff) / 255.0f, alpha};
}

LinearColor ToLinear(const SrgbColor& color);
SrgbColor ToSrgb(const LinearColor& color);

}  // namespace hazumi::render
