#pragma once

#include <array>

#include "render/gl/lighting.h"
#include "render/gl/vertex_stream.h"
#include "render/mesh/ground_occlusion.h"

namespace hazumi::render {

// Draws the ground: a plain part, cheap because it is large, around a rectangle with shadow and
// occlusion.
class GroundPass {
 public:
  GroundPass() = default;
  explicit GroundPass(const GlFunctions& gl);

  // What Draw draws then, as often as it is called. `shaded` may be empty.
  void Upload(const Scene& scene, const GroundRect& shaded);
  // The shadow map is bound to texture unit 0.
  void Draw(const Scene& scene, const FrameView& view);

 private:
  void DrawPart(bool is_shaded, const Scene& scene, const FrameView& view);
  void UploadOcclusion(const GroundOcclusion& occlusion);
  ShaderProgram& Program(GroundLook look, bool is_shaded);

  const GlFunctions* gl_ = nullptr;
  std::array<ShaderProgram, 4> programs_;  // compiled when first needed
  std::array<bool, 4> is_compiled_{};
  VertexStream plain_, inside_;
  GroundRect shaded_;  // part of the drawn ground
  GlTexture openness_;
};

}  // namespace hazumi::render
