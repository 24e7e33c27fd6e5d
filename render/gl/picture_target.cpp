#include "render/gl/picture_target.h"

namespace hazumi::render {
namespace {

void Attach(const GlFunctions& gl, GLuint buffer, GLenum place, GLenum format, PictureSize size,
            int samples) {
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

}  // namespace

PictureTarget::PictureTarget(const GlFunctions& gl, PictureSize size, int samples)
    : gl_(&gl), size_(size), framebuffer_(gl), color_(gl), depth_(gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  const int stored = samples > 1 ? samples : 0;
  Attach(gl, color_.id(), GL_COLOR_ATTACHMENT0, GL_RGBA8, size, stored);
  Attach(gl, depth_.id(), GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, size, stored);
}

bool PictureTarget::is_complete() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  return gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void PictureTarget::Begin(const SrgbColor& clear) const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->Viewport(0, 0, size_.width, size_.height);
  gl_->ClearColor(clear.r, clear.g, clear.b, 1.0f);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PictureTarget::ResolveTo(GLuint framebuffer) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl_->BlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace hazumi::render
