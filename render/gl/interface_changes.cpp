// Layers are compared one by one with those of before. Where a layer has the same triangles, but
// for where their corners are, what they show or how they are coloured, the changed triangles, as
// they were and as they are, bound the change; else all that the layer can be seen through does.

#include "render/gl/interface_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hazumi::render {

namespace {

PixelRect Both(const PixelRect& a, const PixelRect& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

PixelRect SeenThrough(const std::vector<InterfacePart>& parts) {
  PixelRect all;
  for (const InterfacePart& part : parts) {
    all = Both(all, PixelsOf(part.left, part.top, part.right, part.bottom));
  }
  return all;
}

using Vertices = std::span<const InterfaceVertex>;

PixelRect BoundsOf(Vertices vertices, const std::array<std::uint32_t, 3>& corners) {
  const InterfaceVertex &a = vertices[corners[0]], &b = vertices[corners[1]],
                        &c = vertices[corners[2]];
  return PixelsOf(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}),
                  std::max({a.y, b.y, c.y}));
}

// Of the triangles that are not as they were, or of all, in a layer of the same triangles.
PixelRect ChangedIn(const InterfacePart& part, const InterfaceLayer& layer, Vertices before,
                    bool all) {
  PixelRect changed;
  for (std::uint32_t i = part.first_index; i + 3 <= part.first_index + part.num_indices; i += 3) {
    std::array<std::uint32_t, 3> corners;
    bool is_same = !all;
    for (std::uint32_t k = 0; k < 3; ++k) {
      corners[k] = part.first_vertex + layer.indices[i + k];
      is_same = is_same && layer.vertices[corners[k]] == before[corners[k]];
    }
    if (is_same) continue;
    changed = Both(changed, Both(BoundsOf(layer.vertices, corners), BoundsOf(before, corners)));
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
  return common.is_empty() ? PixelRect() : common;
}

PixelRect PixelsOf(float left, float top, float right, float bottom) {
  // Of what is far outside, or nowhere, no whole number could tell where it is.
  constexpr float kFar = 1e6f;
  const auto pixel = [](float place) {
    return static_cast<int>(std::fmin(std::fmax(place, -kFar), kFar));
  };
  return {pixel(std::floor(left)), pixel(std::floor(top)), pixel(std::ceil(right)),
          pixel(std::ceil(bottom))};
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
        !std::ranges::equal(before.indices, layer.indices) || before.parts != layer.parts) {
      rect = Both(SeenThrough(layer.parts), SeenThrough(before.parts));
    } else {
      for (const InterfacePart& part : layer.parts) {
        const bool all = has_new_picture && !is_own(part.texture);
        rect = Both(rect, ChangedIn(part, layer, before.vertices, all));
      }
    }
    rect = Common(rect, whole);
    if (!rect.is_empty()) changed.push_back(rect);
  }
  Keep(layers);
  size_ = size;
  return Merged(std::move(changed));
}

void InterfaceChanges::Keep(const std::vector<InterfaceLayer>& layers) {
  if (!layers_) layers_.emplace();
  layers_->resize(layers.size());
  for (size_t i = 0; i < layers.size(); ++i) {
    const InterfaceLayer& layer = layers[i];
    Kept& kept = (*layers_)[i];
    kept.vertices.assign(layer.vertices.begin(), layer.vertices.end());
    kept.indices.assign(layer.indices.begin(), layer.indices.end());
    kept.parts = layer.parts;
  }
}

}  // namespace hazumi::render
