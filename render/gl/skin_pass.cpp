#include "render/gl/skin_pass.h"

#include <algorithm>

#include "render/gl/shaders.h"

namespace hazumi::render {
namespace {

constexpr GLenum kTextureUnit = GL_TEXTURE2;
constexpr int kTextureSampler = 2;

bool IsGhost(const SkinnedFigure& figure, const SkinModel::Part& part) {
  return figure.AlphaOf(part) < 1.0f;
}

bool IsCutout(const SkinModel& model, const SkinModel::Part& part) {
  return part.texture >= 0 && model.is_cutout[static_cast<size_t>(part.texture)] != 0;
}

}  // namespace

SkinBuffers& SkinPass::BuffersOf(const std::shared_ptr<const SkinModel>& model) {
  const auto found = std::find_if(buffers_.begin(), buffers_.end(),
                                  [&](const auto& b) { return b->IsOf(model.get()); });
  if (found != buffers_.end()) return **found;
  buffers_.push_back(std::make_unique<SkinBuffers>(*gl_, model));
  return *buffers_.back();
}

void SkinPass::Compile() {
  if (is_compiled_) return;
  is_compiled_ = true;
  for (const bool is_cutout : {false, true}) {
    const std::string defines = is_cutout ? "#define SKIN\n#define CUTOUT\n" : "#define SKIN\n";
    Program(Look::kLit, is_cutout) =
        ShaderProgram(*gl_, defines, shaders::kSolidVertex, shaders::kSolidFragment);
    Program(Look::kDepth, is_cutout) =
        ShaderProgram(*gl_, defines, shaders::kDepthVertex, shaders::kDepthFragment);
  }
}

ShaderProgram& SkinPass::Program(Look look, bool is_cutout) {
  return programs_[(look == Look::kLit ? 2 : 0) + (is_cutout ? 1 : 0)];
}

void SkinPass::Upload(const Scene& scene) {
  posed_.clear();
  has_ghosts_ = false;
  gl_->ActiveTexture(kTextureUnit);
  std::erase_if(buffers_, [](const auto& b) { return b->IsGone(); });
  for (const auto& buffers : buffers_) buffers->BeginFrame();
  if (!scene.skins.empty()) Compile();
  for (const SkinnedFigure& figure : scene.skins) {
    SkinBuffers& buffers = BuffersOf(figure.model);
    PoseSkin(figure, &vertices_);
    posed_.push_back({&figure, &buffers, buffers.AddPose(vertices_)});
    for (const SkinModel::Part& part : figure.model->parts) has_ghosts_ |= IsGhost(figure, part);
  }
  for (const auto& buffers : buffers_) buffers->EndFrame();
  gl_->ActiveTexture(GL_TEXTURE0);
}

template <typename Visit>
void SkinPass::ForEachPart(SolidKind kind, bool is_cutout, const Visit& visit) {
  for (const Posed& posed : posed_) {
    posed.buffers->BindPose(posed.pose);
    for (const SkinModel::Part& part : posed.figure->model->parts) {
      const bool is_wanted = IsGhost(*posed.figure, part) == (kind == SolidKind::kGhost) &&
                             IsCutout(*posed.figure->model, part) == is_cutout;
      if (!is_wanted || part.num_indices == 0) continue;
      visit(posed, part);
      posed.buffers->DrawPart(part);
    }
  }
}

// Pushed away from the light: unlike those of closed solids, the lit sides are drawn as well.
void SkinPass::DrawShadow(const ShadowView& shadow) {
  if (posed_.empty()) return;
  gl_->Enable(GL_POLYGON_OFFSET_FILL);
  gl_->PolygonOffset(2.0f, 4.0f);
  DrawDepth(SolidKind::kOpaque, shadow.clip_from_world);
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
}

void SkinPass::DrawDepth(SolidKind kind, const Mat4& clip_from_world) {
  if (posed_.empty()) return;
  gl_->Disable(GL_CULL_FACE);
  gl_->ActiveTexture(kTextureUnit);
  for (const bool is_cutout : {false, true}) {
    const ShaderProgram& program = Program(Look::kDepth, is_cutout);
    program.Use();
    program.Set("clip_from_world", clip_from_world);
    if (is_cutout) program.Set("base_texture", kTextureSampler);
    ForEachPart(kind, is_cutout, [&](const Posed& posed, const SkinModel::Part& part) {
      if (is_cutout) posed.buffers->BindTexture(part);
    });
  }
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->Enable(GL_CULL_FACE);
}

void SkinPass::DrawLit(SolidKind kind, const Scene& scene, const FrameView& view) {
  if (posed_.empty()) return;
  gl_->Disable(GL_CULL_FACE);
  gl_->ActiveTexture(kTextureUnit);
  for (const bool is_cutout : {false, true}) {
    const ShaderProgram& program = Program(Look::kLit, is_cutout);
    program.Use();
    SetSolidLight(program, scene, view);
    program.Set("ghost", kind == SolidKind::kGhost ? 1.0f : 0.0f);
    program.Set("shadow_map", 0);
    program.Set("base_texture", kTextureSampler);
    ForEachPart(kind, is_cutout, [&](const Posed& posed, const SkinModel::Part& part) {
      const std::array<float, 4>& c = part.base_color;
      program.Set("base_linear", LinearColor{c[0], c[1], c[2], c[3]});
      program.Set("alpha", posed.figure->AlphaOf(part));
      posed.buffers->BindTexture(part);
    });
  }
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->Enable(GL_CULL_FACE);
}

}  // namespace hazumi::render
