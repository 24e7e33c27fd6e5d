#include "render/gl/scene_texture.h"

#include <utility>

#include "render/gl/draw_targets.h"

namespace hazumi::render {

struct SceneTexture::State {
  State(const GlFunctions& functions, Renderer drawer)
      : gl(functions), renderer(std::move(drawer)), picture(gl), depth(gl) {}

  void Resize(PictureSize size) {
    if (!picture.Begin(gl, size)) return;
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth.id());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH_COMPONENT24, size.width,
                                      size.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
  }

  GlFunctions gl;
  Renderer renderer;
  DrawnTexture picture;
  GlRenderbuffer depth;
};

SceneTexture::SceneTexture(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneTexture::~SceneTexture() = default;
SceneTexture::SceneTexture(SceneTexture&&) noexcept = default;
SceneTexture& SceneTexture::operator=(SceneTexture&&) noexcept = default;

Result<SceneTexture> SceneTexture::Create(GlProcLoader loader, const RendererOptions& options) {
  const Result<GlFunctions> gl = LoadGlFunctions(loader);
  if (!gl.ok()) return gl.error();
  Result<Renderer> renderer = Renderer::Create(loader, options);
  if (!renderer.ok()) return renderer.error();
  return SceneTexture(std::make_unique<State>(gl.value(), std::move(renderer).value()));
}

Result<unsigned> SceneTexture::Draw(const Scene& scene, PictureSize size) {
  state_->Resize(size);
  const Result<Done> drawn = state_->renderer.Draw(scene, size, state_->picture.framebuffer());
  if (!drawn.ok()) return drawn.error();
  return state_->picture.texture();
}

}  // namespace hazumi::render
