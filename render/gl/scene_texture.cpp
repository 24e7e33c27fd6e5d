#include "render/gl/scene_texture.h"

#include <utility>

#include "render/gl/gl_name.h"

namespace hazumi::render {

struct SceneTexture::State {
  State(const GlFunctions& functions, Renderer drawer)
      : gl(functions), renderer(std::move(drawer)), texture(gl), depth(gl), framebuffer(gl) {}

  void Resize(PictureSize wanted) {
    if (size.width == wanted.width && size.height == wanted.height) return;
    size = wanted;
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth.id());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_DEPTH_COMPONENT24, size.width,
                                      size.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
  }

  GlFunctions gl;
  Renderer renderer;
  GlTexture texture;
  GlRenderbuffer depth;
  GlFramebuffer framebuffer;
  PictureSize size;
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
  const Result<Done> drawn = state_->renderer.Draw(scene, size, state_->framebuffer.id());
  if (!drawn.ok()) return drawn.error();
  return state_->texture.id();
}

}  // namespace hazumi::render
