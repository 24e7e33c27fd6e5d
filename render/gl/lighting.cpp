#include "render/gl/lighting.h"

#include <Eigen/Geometry>

namespace hazumi::render {
namespace {

using Vec4 = Eigen::Vector4d;

constexpr float kKey = 1.28f;
constexpr float kSkyLight = 0.62f;
constexpr float kBounce = 0.42f;
constexpr float kFill = 0.16f;
constexpr float kRim = 0.20f;

LinearColor Scaled(const LinearColor& c, float factor) {
  return {c.r * factor, c.g * factor, c.b * factor, c.a};
}

// Half way to white: coloured light tints, but does not take over.
LinearColor Paler(const LinearColor& c) {
  return {0.5f + 0.5f * c.r, 0.5f + 0.5f * c.g, 0.5f + 0.5f * c.b, c.a};
}

Vec4 Direction(const Vec3& v) { return v.normalized().homogeneous(); }

// From beside the viewer, opposite to the key light.
Vec3 ToFill(const Scene& scene) {
  const Vec3 view = (scene.camera.eye - scene.camera.target).normalized();
  const Vec3 key = scene.to_light.normalized();
  const Vec3 across = key - key.dot(view) * view;
  return view - 1.2 * across;
}

}  // namespace

void SetSolidLight(const ShaderProgram& program, const Scene& scene, const FrameView& view) {
  const LinearColor horizon = ToLinear(scene.sky.horizon);
  program.Set("clip_from_world", view.clip_from_world);
  program.Set("shadow_from_world", view.shadow.map_from_world);
  program.Set("shadow_offset_m", static_cast<float>(2.0 * view.shadow.texel_m));
  program.Set("eye", Vec4(scene.camera.eye.homogeneous()));
  program.Set("to_light", Direction(scene.to_light));
  program.Set("to_fill", Direction(ToFill(scene)));
  program.Set("key_linear", LinearColor{kKey, kKey * 0.965f, kKey * 0.91f, 1.0f});
  program.Set("above_linear", Scaled(Paler(horizon), kSkyLight));
  program.Set("below_linear", Scaled(ToLinear(scene.ground.floor), kBounce));
  program.Set("fill_linear", Scaled(Paler(horizon), kFill));
  program.Set("rim_linear", Scaled(horizon, kRim));
  program.Set("ground_height", static_cast<float>(scene.ground.height));
}

}  // namespace hazumi::render
