#include "render/gl/ground_pass.h"

#include <algorithm>

#include "render/gl/shaders.h"

namespace hazumi::render {
namespace {

using Vec4 = Eigen::Vector4d;

constexpr double kLeastRadius = 26.0;  // where the ground has faded into the horizon [m]
constexpr double kRadiusPerDistance = 4.0;
constexpr SrgbColor kShadowTint = FromHex(0xa6abb4);
constexpr SrgbColor kOcclusionTint = FromHex(0x50545c);

struct PlaneVertex {
  float x, y;
};

double FadeRadius(const Camera& camera) {
  return std::max(kLeastRadius, kRadiusPerDistance * (camera.eye - camera.target).norm());
}

void AppendRect(const GroundRect& r, std::vector<PlaneVertex>& out) {
  const float x0 = float(r.min.x()), y0 = float(r.min.y());
  const float x1 = float(r.max.x()), y1 = float(r.max.y());
  if (x1 <= x0 || y1 <= y0) return;
  out.insert(out.end(), {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y0}, {x1, y1}, {x0, y1}});
}

// `whole` without `hole`: eight rectangles around it, so that corners meet at corners.
std::vector<PlaneVertex> Around(const GroundRect& whole, const GroundRect& hole) {
  std::vector<PlaneVertex> out;
  const double xs[] = {whole.min.x(), hole.min.x(), hole.max.x(), whole.max.x()};
  const double ys[] = {whole.min.y(), hole.min.y(), hole.max.y(), whole.max.y()};
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      if (row == 1 && i == 1) continue;
      AppendRect({{xs[i], ys[row]}, {xs[i + 1], ys[row + 1]}}, out);
    }
  }
  return out;
}

GroundRect Clamped(const GroundRect& rect, const GroundRect& whole) {
  GroundRect r;
  r.min = rect.min.cwiseMax(whole.min).cwiseMin(whole.max);
  r.max = rect.max.cwiseMin(whole.max).cwiseMax(r.min);
  return r;
}

}  // namespace

GroundPass::GroundPass(const GlFunctions& gl)
    : gl_(&gl), plain_(gl, {2}), inside_(gl, {2}), openness_(gl) {
  gl.BindTexture(GL_TEXTURE_2D, openness_.id());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  }
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  }
}

ShaderProgram& GroundPass::Program(GroundLook look, bool is_shaded) {
  const size_t i = (look == GroundLook::kChecker ? 2 : 0) + (is_shaded ? 1 : 0);
  if (!is_compiled_[i]) {
    std::string defines = look == GroundLook::kChecker ? "#define CHECKER\n" : "";
    if (is_shaded) defines += "#define SHADED\n";
    programs_[i] = ShaderProgram(*gl_, defines, shaders::kGroundVertex, shaders::kGroundFragment);
    is_compiled_[i] = true;
  }
  return programs_[i];
}

void GroundPass::UploadOcclusion(const GroundOcclusion& occlusion) {
  constexpr int kSize = GroundOcclusion::kSize;
  gl_->ActiveTexture(GL_TEXTURE1);
  gl_->BindTexture(GL_TEXTURE_2D, openness_.id());
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSize, kSize, 0, GL_RED, GL_UNSIGNED_BYTE,
                  occlusion.openness.data());
  gl_->ActiveTexture(GL_TEXTURE0);
}

void GroundPass::Upload(const Scene& scene, const GroundRect& shaded) {
  const double radius = FadeRadius(scene.camera);
  GroundRect whole;
  whole.Include(scene.camera.target.head<2>(), radius);
  shaded_ = Clamped(shaded.is_empty() ? GroundRect{whole.min, whole.min} : shaded, whole);
  plain_.Upload(Around(whole, shaded_));
  std::vector<PlaneVertex> inside;
  AppendRect(shaded_, inside);
  inside_.Upload(inside);
  if (!inside.empty()) UploadOcclusion(OccludeGround(scene, shaded_));
}

void GroundPass::Draw(const Scene& scene, const FrameView& view) {
  DrawPart(false, scene, view);
  if (inside_.has_vertices()) DrawPart(true, scene, view);
}

void GroundPass::DrawPart(bool is_shaded, const Scene& scene, const FrameView& view) {
  const Vec3& target = scene.camera.target;
  const Eigen::Vector2d size = shaded_.max - shaded_.min;
  ShaderProgram& program = Program(scene.ground.look, is_shaded);
  program.Use();
  program.Set("clip_from_world", view.clip_from_world);
  program.Set("shadow_from_world", view.shadow.map_from_world);
  program.Set("center",
              Vec4(target.x(), target.y(), scene.ground.height, 1.0 / FadeRadius(scene.camera)));
  program.Set("shaded_rect",
              Vec4(shaded_.min.x(), shaded_.min.y(), 1.0 / size.x(), 1.0 / size.y()));
  program.Set("shadow_step", Vec4(view.shadow_texel_uv, view.shadow_texel_uv, 0.0, 0.0));
  program.Set("floor_srgb", scene.ground.floor);
  program.Set("pattern_srgb", scene.ground.pattern);
  program.Set("horizon_srgb", scene.sky.horizon);
  program.Set("shadow_tint", kShadowTint);
  program.Set("occlusion_tint", kOcclusionTint);
  program.Set("shadow_map", 0);
  program.Set("openness", 1);
  (is_shaded ? inside_ : plain_).DrawTriangles();
}

}  // namespace hazumi::render
