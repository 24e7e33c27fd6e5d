#include "render/gl/drawn_texture.h"

namespace hazumi::render {

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
