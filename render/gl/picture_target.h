#pragma once

#include "render/gl/gl_name.h"
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

}  // namespace hazumi::render
