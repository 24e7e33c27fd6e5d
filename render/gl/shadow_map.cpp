#include "render/gl/shadow_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hazumi::render {
namespace {

constexpr double kExtentStep = 0.5;  // [m]

// Rows: two directions across the light, and towards it.
Mat3 LightAxes(const Vec3& to_light) {
  const Vec3 z = to_light.normalized();
  const Vec3 helper = std::abs(z.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX();
  const Vec3 x = helper.cross(z).normalized();
  Mat3 R;
  R << x.transpose(), z.cross(x).transpose(), z.transpose();
  return R;
}

struct LightBox {
  Vec3 low = Vec3::Constant(1e30), high = Vec3::Constant(-1e30);
};

LightBox BoxOf(const std::vector<BoundingSphere>& casters, const Mat3& R_LW) {
  LightBox box;
  for (const BoundingSphere& s : casters) {
    const Vec3 center = R_LW * s.center;
    box.low = box.low.cwiseMin(Vec3(center.array() - s.radius));
    box.high = box.high.cwiseMax(Vec3(center.array() + s.radius));
  }
  if (casters.empty()) box.low.setConstant(-1.0), box.high.setConstant(1.0);
  return box;
}

Mat4 ToUnitCube() {
  Mat4 m = Mat4::Identity();
  m.diagonal().head<3>().setConstant(0.5);
  m.topRightCorner<3, 1>().setConstant(0.5);
  return m;
}

}  // namespace

ShadowView FitShadow(const std::vector<BoundingSphere>& casters, const Vec3& to_light,
                     int size_px) {
  const Mat3 R_LW = LightAxes(to_light);
  const LightBox box = BoxOf(casters, R_LW);
  const Vec3 size = box.high - box.low;
  const double needed = std::max(size.x(), size.y()) * (1.0 + 4.0 / size_px);
  const double extent = std::ceil(needed / kExtentStep) * kExtentStep;
  const double texel = extent / size_px;
  Vec3 middle = 0.5 * (box.low + box.high);
  for (int k = 0; k < 2; ++k) middle[k] = std::round(middle[k] / texel) * texel;
  const double depth = size.z() + 0.1;
  const Vec3 scale(2.0 / extent, 2.0 / extent, -2.0 / depth);
  ShadowView view;
  view.clip_from_world.topLeftCorner<3, 3>() = scale.asDiagonal() * R_LW;
  view.clip_from_world.topRightCorner<3, 1>() = -scale.cwiseProduct(middle);
  view.map_from_world = ToUnitCube() * view.clip_from_world;
  view.texel_m = texel;
  return view;
}

ShadowMap::ShadowMap(const GlFunctions& gl, int size_px)
    : gl_(&gl), size_px_(size_px), texture_(gl), framebuffer_(gl) {
  const float lit[] = {1.0f, 1.0f, 1.0f, 1.0f};
  gl.BindTexture(GL_TEXTURE_2D, texture_.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size_px, size_px, 0, GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_.id(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
}

void ShadowMap::Begin() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  gl_->Viewport(0, 0, size_px_, size_px_);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace hazumi::render
