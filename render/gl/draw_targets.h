#pragma once

// Framebuffers that are drawn into: of a picture, and of a texture for a window.

#include "render/gl/gl_name.h"
#include "render/mesh/flat_mesh.h"
#include "render/mesh/picture_area.h"

namespace hazumi::render {

// Binds a framebuffer for drawing and clears it to `clear`, as far as the scissors reach.
void BeginPicture(const GlFunctions& gl, GLuint framebuffer, PictureSize size,
                  const SrgbColor& clear);

// The multisampled colour and depth buffers a frame is drawn into.
class PictureTarget {
 public:
  PictureTarget() = default;
  PictureTarget(const GlFunctions& gl, PictureSize size, int samples);

  PictureSize size() const { return size_; }
  bool is_complete() const;
  void Begin(const SrgbColor& clear) const { BeginPicture(*gl_, framebuffer_.id(), size_, clear); }
  // Averages the samples of an area into a framebuffer of the same size. Leaves both bound, to read
  // and to draw.
  void ResolveTo(GLuint framebuffer, const PictureArea& area) const;

 private:
  const GlFunctions* gl_ = nullptr;
  PictureSize size_;
  GlFramebuffer framebuffer_;
  GlRenderbuffer color_, depth_;
};

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
