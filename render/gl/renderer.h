#pragma once

#include <memory>

#include "engine/base/result.h"
#include "render/gl/gl_functions.h"
#include "render/mesh/flat_mesh.h"
#include "render/scene/scene.h"

namespace hazumi::render {

struct RendererOptions {
  int samples = 4;  // per pixel: 1 or 4; 0 counts as 1, 2 and 3 as 4, more as 4
  bool shadow = true;
  int shadow_map_px = 1024;  // edge of the shadow map, which is fitted to the figures
};

// Draws scenes with whatever OpenGL 3.3 core context is current: it knows neither windows nor
// OSMesa. Make, use and destroy it with the same context current.
class Renderer {
 public:
  // Fails (kFailed) when the context lacks a function.
  static Result<Renderer> Create(GlProcLoader loader, const RendererOptions& options);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // Draws into `framebuffer` (0: the context's own), which has this size. Ends without waiting:
  // call Finish() before reading what a context drew to memory.
  // Fails (kFailed) when the driver has no memory for a picture of this size.
  Result<Done> Draw(const Scene& scene, PictureSize size, unsigned framebuffer = 0);
  void Finish();

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hazumi::render
