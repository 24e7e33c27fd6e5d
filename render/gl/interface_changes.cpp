// Layers are compared one by one with those of before. Where a layer has the same triangles, but
// for where their corners are, what they show or how they are coloured, the changed triangles, as
// they were and as they are, bound the change; else all that the layer can be seen through does.

#include "render/gl/interface_changes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace hazumi::render {

namespace {

constexpr PixelRect kNothing = {};

PixelRect Both(const PixelRect& a, const PixelRect& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

template <typename Items>
bool AreSame(const Items& a, const auto& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

PixelRect SeenThrough(const std::vector<InterfacePart>& parts) {
  PixelRect all;
  for (const InterfacePart& part : parts) {
    all = Both(all, PixelsOf(part.left, part.top, part.right, part.bottom));
  }
  return all;
}

template <typename Vertices>
PixelRect BoundsOf(const Vertices& vertices, const std::uint32_t (&corners)[3]) {
  const InterfaceVertex &a = vertices[corners[0]], &b = vertices[corners[1]],
                        &c = vertices[corners[2]];
  return PixelsOf(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}),
                  std::max({a.y, b.y, c.y}));
}

bool AreSame(const InterfaceVertex& a, const InterfaceVertex& b) {
  return a.x == b.x && a.y == b.y && a.u == b.u && a.v == b.v && a.rgba == b.rgba;
}

// Of the triangles that are not as they were, in layers of the same triangles.
template <typename Before>
PixelRect ChangedIn(const InterfacePart& part, const InterfaceLayer& layer, const Before& before,
                    bool all) {
  PixelRect changed;
  for (std::uint32_t i = part.first_index; i + 3 <= part.first_index + part.num_indices; i += 3) {
    std::uint32_t corners[3];
    bool is_same = !all;
    for (int k = 0; k < 3; ++k) {
      corners[k] = part.first_vertex + layer.indices[i + static_cast<std::uint32_t>(k)];
      is_same = is_same && AreSame(layer.vertices[corners[k]], before.vertices[corners[k]]);
    }
    if (is_same) continue;
    changed =
        Both(changed, Both(BoundsOf(layer.vertices, corners), BoundsOf(before.vertices, corners)));
  }
  return Common(changed, PixelsOf(part.left, part.top, part.right, part.bottom));
}

// Those that overlap become one.
std::vector<PixelRect> Merged(std::vector<PixelRect> rects) {
  for (size_t i = 0; i < rects.size(); ++i) {
    for (size_t k = i + 1; k < rects.size(); ++k) {
      if (Common(rects[i], rects[k]).is_empty()) continue;
      rects[i] = Both(rects[i], rects[k]);
      rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(k));
      i = static_cast<size_t>(-1);  // it may reach others now
      break;
    }
  }
  return rects;
}

}  // namespace

PixelRect Common(const PixelRect& a, const PixelRect& b) {
  const PixelRect common = {std::max(a.left, b.left), std::max(a.top, b.top),
                            std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
  return common.is_empty() ? kNothing : common;
}

PixelRect PixelsOf(float left, float top, float right, float bottom) {
  return {static_cast<int>(std::floor(left)), static_cast<int>(std::floor(top)),
          static_cast<int>(std::ceil(right)), static_cast<int>(std::ceil(bottom))};
}

std::vector<PixelRect> InterfaceChanges::Since(const std::vector<InterfaceLayer>& layers,
                                               PictureSize size, bool has_new_picture,
                                               const std::function<bool(unsigned)>& is_own) {
  const PixelRect whole = {0, 0, size.width, size.height};
  const bool is_other = !layers_ || layers_->size() != layers.size() || size_.width != size.width ||
                        size_.height != size.height;
  std::vector<PixelRect> changed;
  if (is_other) changed.push_back(whole);
  for (size_t i = 0; !is_other && i < layers.size(); ++i) {
    const InterfaceLayer& layer = layers[i];
    const Kept& before = (*layers_)[i];
    PixelRect rect;
    if (layer.vertices.size() != before.vertices.size() ||
        !AreSame(before.indices, layer.indices) || !AreSame(before.parts, layer.parts)) {
      rect = Both(SeenThrough(layer.parts), SeenThrough(before.parts));
    } else {
      for (const InterfacePart& part : layer.parts) {
        const bool all = has_new_picture && !is_own(part.texture);
        rect = Both(rect, ChangedIn(part, layer, before, all));
      }
    }
    rect = Common(rect, whole);
    if (!rect.is_empty()) changed.push_back(rect);
  }
  layers_.emplace();
  for (const InterfaceLayer& layer : layers) {
    layers_->push_back({{layer.vertices.begin(), layer.vertices.end()},
                        {layer.indices.begin(), layer.indices.end()},
                        layer.parts});
  }
  size_ = size;
  return Merged(std::move(changed));
}

}  // namespace hazumi::render
