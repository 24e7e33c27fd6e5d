#pragma once

#include "render/gl/gl_name.h"
#include "render/scene/bounds.h"

namespace hazumi::render {

// How a directional light sees the casters.
struct ShadowView {
  Mat4 clip_from_world = Mat4::Identity();
  Mat4 map_from_world = Mat4::Identity();  // to [0, 1]^3
  double texel_m = 0.0;
};

// Holds all casters. The map's extent grows in steps of 0.5 m and its origin moves by whole texels,
// so that shadow edges do not crawl when the figure moves.
ShadowView FitShadow(const std::vector<BoundingSphere>& casters, const Vec3& to_light, int size_px);

// A square depth texture that answers comparisons; outside is lit.
class ShadowMap {
 public:
  ShadowMap() = default;
  ShadowMap(const GlFunctions& gl, int size_px);

  int size_px() const { return size_px_; }
  GLuint texture() const { return texture_.id(); }
  // Binds the map as the target of drawing and clears it.
  void Begin() const;

 private:
  const GlFunctions* gl_ = nullptr;
  int size_px_ = 0;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
};

}  // namespace hazumi::render
