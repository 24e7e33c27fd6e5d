#include "render/gl/draw_targets.h"

namespace hazumi::render {

namespace {

void Attach(const GlFunctions& gl, GLuint buffer, GLenum place, GLenum format, PictureSize size,
            int samples) {
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

}  // namespace

void BeginPicture(const GlFunctions& gl, GLuint framebuffer, PictureSize size,
                  const SrgbColor& clear) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, size.width, size.height);
  gl.ClearColor(clear.r, clear.g, clear.b, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

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

void PictureTarget::ResolveTo(GLuint framebuffer, const PictureArea& area) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl_->BlitFramebuffer(area.left, area.bottom, area.right, area.top, area.left, area.bottom,
                       area.right, area.top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

bool DrawnTexture::Begin(const GlFunctions& gl, PictureSize size) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  if (size_.width == size.width && size_.height == size.height) return false;
  size_ = size;
  gl.BindTexture(GL_TEXTURE_2D, texture_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  }
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
  return true;
}

}  // namespace hazumi::render
