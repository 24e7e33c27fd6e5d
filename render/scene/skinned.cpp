#include "render/scene/skinned.h"

namespace hazumi::render {

BoneTint LaidOver(const BoneTint& over, const BoneTint& below) {
  const float rest = below.a * (1.0f - over.a), share = over.a + rest;
  if (share <= 0.0f) return {0.0f, 0.0f, 0.0f, 0.0f};
  const float s = over.a / share, r = rest / share;
  return {s * over.r + r * below.r, s * over.g + r * below.g, s * over.b + r * below.b, share};
}

}  // namespace hazumi::render
