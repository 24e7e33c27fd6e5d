#pragma once

#include <memory>

#include "engine/base/result.h"
#include "engine/picture/image.h"
#include "render/contexts/osmesa_context.h"
#include "render/gl/renderer.h"

namespace hazumi::render {

// A renderer with a context of its own and no screen. Use it on the thread that made it.
class OffscreenRenderer {
 public:
  // Errors: those of OsmesaContext and Renderer.
  static Result<OffscreenRenderer> Create(const RendererOptions& options);
  ~OffscreenRenderer();
  OffscreenRenderer(OffscreenRenderer&&) noexcept = default;
  OffscreenRenderer& operator=(OffscreenRenderer&&) = delete;

  // Fills `image`, whose size (at least 1 x 1) is the picture's.
  Result<Done> Draw(const Scene& scene, Image& image);

 private:
  OffscreenRenderer(std::unique_ptr<Image> first_buffer, OsmesaContext context, Renderer renderer);

  std::unique_ptr<Image> first_buffer_;  // what the context draws to while no picture is asked for
  std::unique_ptr<OsmesaContext> context_;
  std::unique_ptr<Renderer> renderer_;
};

}  // namespace hazumi::render
