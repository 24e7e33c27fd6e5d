#pragma once

#include "render/gl/shader_program.h"
#include "render/gl/shadow_map.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// What all shading of one frame shares.
struct FrameView {
  Mat4 clip_from_world = Mat4::Identity();
  ShadowView shadow;
  double shadow_texel_uv = 0.0;  // in map coordinates
};

// Sets the light uniforms of the solid program in use.
void SetSolidLight(const ShaderProgram& program, const Scene& scene, const FrameView& view);

}  // namespace hazumi::render
