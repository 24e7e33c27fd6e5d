#include "render/gl/renderer.h"

#include <string>
#include <utility>

#include "render/gl/frame_drawer.h"

namespace hazumi::render {

// The function table stays in place for all who point to it.
struct Renderer::State {
  State(const GlFunctions& functions, const RendererOptions& options)
      : gl(functions), drawer(gl, options) {}
  GlFunctions gl;
  FrameDrawer drawer;
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Result<Renderer> Renderer::Create(GlProcLoader loader, const RendererOptions& options) {
  const Result<GlFunctions> gl = LoadGlFunctions(loader);
  if (!gl.ok()) return gl.error();
  return Renderer(std::make_unique<State>(gl.value(), options));
}

Result<Done> Renderer::Draw(const Scene& scene, PictureSize size, unsigned framebuffer) {
  if (!state_->drawer.Resize(size)) {
    return Error{ErrorCode::kFailed, "", "OpenGL",
                 "the driver cannot make a picture of " + std::to_string(size.width) + " x " +
                     std::to_string(size.height) + " pixels; choose a smaller size"};
  }
  state_->drawer.Draw(scene, framebuffer);
  return Done{};
}

void Renderer::Finish() { state_->gl.Finish(); }

}  // namespace hazumi::render
