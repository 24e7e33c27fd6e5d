#pragma once

#include "render/gl/gl_name.h"
#include "render/mesh/flat_mesh.h"

namespace hazumi::render {

// The multisampled colour and depth buffers a frame is drawn into.
class PictureTarget {
 public:
  PictureTarget() = default;
  PictureTarget(const GlFunctions& gl, PictureSize size, int samples);

  PictureSize size() const { return size_; }
  bool is_complete() const;
  // Binds it for drawing and clears it to `clear`.
  void Begin(const SrgbColor& clear) const;
  // Averages the samples into a framebuffer of the same size and binds that for drawing.
  void ResolveTo(GLuint framebuffer) const;

 private:
  const GlFunctions* gl_ = nullptr;
  PictureSize size_;
  GlFramebuffer framebuffer_;
  GlRenderbuffer color_, depth_;
};

}  // namespace hazumi::render
