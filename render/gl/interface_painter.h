#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/gl/gl_functions.h"
#include "render/mesh/flat_mesh.h"

namespace hazumi::render {

// A vertex of the interface: pixels from the upper left corner, a place in the texture, and a
// colour whose bytes are r, g, b, a (sRGB).
struct InterfaceVertex {
  float x, y, u, v;
  std::uint32_t rgba;
  bool operator==(const InterfaceVertex&) const = default;
};

// Triangles of one texture, seen through a rectangle [px].
struct InterfacePart {
  float left, top, right, bottom;
  unsigned texture;
  std::uint32_t first_index, num_indices, first_vertex;
  bool operator==(const InterfacePart&) const = default;
};

// Parts in drawing order, with the vertices that their indices count.
struct InterfaceLayer {
  std::span<const InterfaceVertex> vertices;
  std::span<const std::uint16_t> indices;
  std::vector<InterfacePart> parts;
};

// Draws a user interface with whatever OpenGL 3.3 core context is current, a window's or OSMesa's.
// Make, use and destroy it with the same context current.
class InterfacePainter {
 public:
  // Fails (kFailed) when the context lacks a function.
  static Result<InterfacePainter> Create(GlProcLoader loader);
  ~InterfacePainter();
  InterfacePainter(InterfacePainter&&) noexcept;
  InterfacePainter& operator=(InterfacePainter&&) noexcept;

  // A texture that lives as long as the painter or until it is freed. `rgba`: bytes, top row first.
  unsigned AddTexture(const std::uint8_t* rgba, PictureSize size);
  void FreeTexture(unsigned texture);

  // Fills the context's own framebuffer, which has this size. Only what differs from what it drew
  // last is drawn anew; `has_new_picture`: textures that are not its own show something else.
  void Draw(const std::vector<InterfaceLayer>& layers, PictureSize size, const SrgbColor& clear,
            bool has_new_picture);
  // Waits until everything is drawn.
  void Finish();

 private:
  struct State;
  explicit InterfacePainter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hazumi::render
