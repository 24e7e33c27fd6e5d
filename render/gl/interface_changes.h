#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "render/gl/interface_painter.h"

namespace hazumi::render {

// Whole pixels of a window, from its upper left corner; right and bottom are not in it.
struct PixelRect {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool is_empty() const { return right <= left || bottom <= top; }
  bool operator==(const PixelRect&) const = default;
};

PixelRect Common(const PixelRect& a, const PixelRect& b);
// The pixels that a rectangle touches.
PixelRect PixelsOf(float left, float top, float right, float bottom);

// Where an interface differs from how it was drawn last.
class InterfaceChanges {
 public:
  // Rectangles that do not overlap; outside of them the layers give the same pixels as the layers
  // before. `has_new_picture`: the textures that `is_own` says no to show something else.
  std::vector<PixelRect> Since(const std::vector<InterfaceLayer>& layers, PictureSize size,
                               bool has_new_picture, const std::function<bool(unsigned)>& is_own);
  // Everything is to be drawn next.
  void Forget() { layers_.reset(); }

 private:
  struct Kept {
    std::vector<InterfaceVertex> vertices;
    std::vector<std::uint16_t> indices;
    std::vector<InterfacePart> parts;
  };
  void Keep(const std::vector<InterfaceLayer>& layers);

  std::optional<std::vector<Kept>> layers_;
  PictureSize size_;
};

}  // namespace hazumi::render
