#pragma once

#include "render/gl/gl_name.h"
#include "render/mesh/flat_mesh.h"

namespace hazumi::render {

// A texture of a window's pixels, shown one to one, with a framebuffer that draws into it.
class DrawnTexture {
 public:
  explicit DrawnTexture(const GlFunctions& gl) : texture_(gl), framebuffer_(gl) {}

  // Binds the framebuffer. True if the texture is of another size than before; then it is empty.
  bool Begin(const GlFunctions& gl, PictureSize size);
  PictureSize size() const { return size_; }
  GLuint texture() const { return texture_.id(); }
  GLuint framebuffer() const { return framebuffer_.id(); }

 private:
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  PictureSize size_;
};

}  // namespace hazumi::render
