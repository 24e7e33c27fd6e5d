#include "render/gl/skin_pass.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "render/gl/shaders.h"
#include "render/scene/skin_triangles.h"

namespace hazumi::render {
namespace {

constexpr GLenum kTextureUnit = GL_TEXTURE2;
constexpr int kTextureSampler = 2;
constexpr GLenum kEmissionUnit = GL_TEXTURE4;
constexpr int kEmissionSampler = 4;

bool IsGhost(const SkinnedFigure& figure, const SkinModel::Part& part) {
  return figure.AlphaOf(part) < 1.0f;
}

constexpr SkinModel::Surface kSurfaces[] = {SkinModel::Surface::kClosed, SkinModel::Surface::kOpen,
                                            SkinModel::Surface::kCutout};
constexpr const char* kDefines[] = {"#define SKIN\n", "#define SKIN\n#define TWO_SIDED\n",
                                    "#define SKIN\n#define TWO_SIDED\n#define CUTOUT\n"};

PictureBounds BoundsOf(const SkinModel& model, const std::vector<SkinnedVertex>& vertices,
                       const Projector& projector) {
  PictureBounds bounds(projector);
  for (const std::uint32_t i : model.seen_vertices) {
    bounds.Include(Eigen::Map<const Eigen::Vector3f>(vertices[i].position));
  }
  return bounds;
}

}  // namespace

SkinBuffers& SkinPass::BuffersOf(const std::shared_ptr<const SkinModel>& model) {
  const auto found = std::find_if(buffers_.begin(), buffers_.end(),
                                  [&](const auto& b) { return b->IsOf(model.get()); });
  if (found != buffers_.end()) return **found;
  buffers_.push_back(std::make_unique<SkinBuffers>(*gl_, model));
  return *buffers_.back();
}

SkinPass::Finish SkinPass::FinishOf(const SkinModel::Part& part) {
  const bool shines = part.emission != std::array<float, 3>{0.0f, 0.0f, 0.0f};
  const bool is_textured = part.texture >= 0 || (shines && part.emission_texture >= 0);
  return {is_textured, part.has_colors, shines};
}

ShaderProgram& SkinPass::Lit(Surface surface, const Finish& finish) {
  const auto i = static_cast<size_t>(surface);
  const size_t number =
      (finish.is_textured ? 1u : 0u) + (finish.has_colors ? 2u : 0u) + (finish.shines ? 4u : 0u);
  std::optional<ShaderProgram>& program = lit_[kNumFinishes * i + number];
  if (!program) {
    std::string defines = kDefines[i];
    if (finish.is_textured) defines += "#define TEXTURED\n";
    if (finish.has_colors) defines += "#define COLORED\n";
    if (finish.shines) defines += "#define EMISSIVE\n";
    program.emplace(*gl_, defines, shaders::kSolidVertex, shaders::kSolidFragment);
  }
  return *program;
}

ShaderProgram& SkinPass::Depth(Surface surface) {
  const auto i = static_cast<size_t>(surface);
  if (!depth_[i]) {
    depth_[i].emplace(*gl_, kDefines[i], shaders::kDepthVertex, shaders::kDepthFragment);
  }
  return *depth_[i];
}

std::vector<PictureArea> SkinPass::Upload(const Scene& scene, const Projector& projector) {
  std::vector<PictureArea> areas;
  posed_.clear();
  has_ghosts_ = false;
  gl_->ActiveTexture(kTextureUnit);
  std::erase_if(buffers_, [](const auto& b) { return b->IsGone(); });
  for (const auto& buffers : buffers_) buffers->BeginFrame();
  for (const SkinnedFigure& figure : scene.skins) {
    SkinBuffers& buffers = BuffersOf(figure.model);
    PoseSkin(figure, &vertices_);
    const PictureBounds bounds = BoundsOf(*figure.model, vertices_, projector);
    areas.push_back(bounds.area());
    posed_.push_back({&figure, &buffers, buffers.AddPose(vertices_), bounds.pixels_per_m()});
    for (const SkinModel::Part& part : figure.model->parts) has_ghosts_ |= IsGhost(figure, part);
  }
  for (const auto& buffers : buffers_) buffers->EndFrame();
  gl_->ActiveTexture(GL_TEXTURE0);
  return areas;
}

void SkinPass::Cull(const SkinModel::Part& part, Side side) const {
  const bool is_closed = part.surface == Surface::kClosed;
  is_closed ? gl_->Enable(GL_CULL_FACE) : gl_->Disable(GL_CULL_FACE);
  gl_->CullFace((side == Side::kSeen) != part.is_mirrored ? GL_BACK : GL_FRONT);
}

template <typename Visit>
void SkinPass::ForEachPart(SolidKind kind, Surface surface, Side side, const Visit& visit) {
  gl_->ActiveTexture(kTextureUnit);
  for (const Posed& posed : posed_) {
    posed.buffers->BindPose(posed.pose);
    for (const SkinModel::Part& part : posed.figure->model->parts) {
      const bool is_wanted = IsGhost(*posed.figure, part) == (kind == SolidKind::kGhost);
      if (!is_wanted || part.surface != surface) continue;
      Cull(part, side);
      if (!visit(posed, part)) continue;
      posed.buffers->DrawLevel(LevelFor(part, posed.pixels_per_m, kOutlineErrorPx));
    }
  }
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->Enable(GL_CULL_FACE);
  gl_->CullFace(GL_BACK);
}

// Pushed away from the light: of open surfaces, the lit sides are drawn as well.
void SkinPass::DrawShadow(const ShadowView& shadow) {
  if (posed_.empty()) return;
  gl_->Enable(GL_POLYGON_OFFSET_FILL);
  gl_->PolygonOffset(2.0f, 4.0f);
  DrawDepth(SolidKind::kOpaque, Side::kAway, shadow.clip_from_world);
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
}

void SkinPass::DrawDepth(SolidKind kind, const Mat4& clip_from_world) {
  DrawDepth(kind, Side::kSeen, clip_from_world);
}

void SkinPass::DrawDepth(SolidKind kind, Side side, const Mat4& clip_from_world) {
  if (posed_.empty()) return;
  for (const Surface surface : kSurfaces) {
    const ShaderProgram& program = Depth(surface);
    program.Use();
    program.Set("clip_from_world", clip_from_world);
    if (surface == Surface::kCutout) program.Set("base_texture", kTextureSampler);
    ForEachPart(kind, surface, side, [&](const Posed& posed, const SkinModel::Part& part) {
      if (surface == Surface::kCutout) posed.buffers->BindTexture(part.texture);
      return true;
    });
  }
}

void SkinPass::DrawLit(SolidKind kind, const Scene& scene, const FrameView& view) {
  if (posed_.empty()) return;
  for (const Surface surface : kSurfaces) {
    for (const bool is_textured : {false, true}) {
      for (const bool has_colors : {false, true}) {
        for (const bool shines : {false, true}) {
          DrawLit(kind, surface, {is_textured, has_colors, shines}, scene, view);
        }
      }
    }
  }
}

void SkinPass::DrawLit(SolidKind kind, Surface surface, const Finish& finish, const Scene& scene,
                       const FrameView& view) {
  const ShaderProgram* program = nullptr;  // until a part needs it
  ForEachPart(kind, surface, Side::kSeen, [&](const Posed& posed, const SkinModel::Part& part) {
    if (FinishOf(part) != finish) return false;
    if (program == nullptr) {
      program = &Lit(surface, finish);
      program->Use();
      SetSolidLight(*program, scene, view);
      program->Set("ghost", kind == SolidKind::kGhost ? 1.0f : 0.0f);
      program->Set("shadow_map", 0);
      if (finish.is_textured) program->Set("base_texture", kTextureSampler);
      if (finish.is_textured && finish.shines) program->Set("emission_texture", kEmissionSampler);
    }
    const std::array<float, 4>& c = part.base_color;
    program->Set("base_linear", LinearColor{c[0], c[1], c[2], c[3]});
    program->Set("alpha", posed.figure->AlphaOf(part));
    if (finish.is_textured) posed.buffers->BindTexture(part.texture);
    if (finish.shines) {
      const std::array<float, 3>& e = part.emission;
      program->Set("emission_linear", LinearColor{e[0], e[1], e[2], 1.0f});
    }
    if (finish.is_textured && finish.shines) {
      gl_->ActiveTexture(kEmissionUnit);
      posed.buffers->BindTexture(part.emission_texture);
      gl_->ActiveTexture(kTextureUnit);
    }
    return true;
  });
}

}  // namespace hazumi::render
