#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "render/gl/lighting.h"
#include "render/gl/skin_buffers.h"
#include "render/mesh/picture_area.h"
#include "render/mesh/solid_mesh.h"

namespace hazumi::render {

// Draws the skins of a frame, in the passes of the other solids.
class SkinPass {
 public:
  SkinPass() = default;
  explicit SkinPass(const GlFunctions& gl) : gl_(&gl) {}

  // Poses the scene's skins, and frees what belonged to skins that nobody has any more.
  // Returns where they are in the picture.
  std::vector<PictureArea> Upload(const Scene& scene, const Projector& projector);
  bool has_ghosts() const { return has_ghosts_; }

  // Opaque skins as the light sees them.
  void DrawShadow(const ShadowView& shadow);
  // Depth alone, or light. The shadow map is bound to texture unit 0.
  void DrawDepth(SolidKind kind, const Mat4& clip_from_world);
  void DrawLit(SolidKind kind, const Scene& scene, const FrameView& view);

 private:
  struct Posed {
    const SkinnedFigure* figure;  // of the scene, for the time of its drawing
    SkinBuffers* buffers;
    size_t pose;
    double pixels_per_m;  // where it is nearest
  };
  using Surface = SkinModel::Surface;
  enum class Side { kSeen, kAway };  // of closed surfaces
  // Kind of light that a part needs; each has its own program.
  struct Finish {
    bool is_textured = false, has_colors = false, shines = false;
    bool operator==(const Finish&) const = default;
  };
  static constexpr int kNumFinishes = 8;

  static Finish FinishOf(const SkinModel::Part& part);

  SkinBuffers& BuffersOf(const std::shared_ptr<const SkinModel>& model);
  ShaderProgram& Lit(Surface surface, const Finish& finish);
  ShaderProgram& Depth(Surface surface);
  void DrawDepth(SolidKind kind, Side side, const Mat4& clip_from_world);
  void DrawLit(SolidKind kind, Surface surface, const Finish& finish, const Scene& scene,
               const FrameView& view);
  // Draws the parts of which `visit` says so.
  template <typename Visit>
  void ForEachPart(SolidKind kind, Surface surface, Side side, const Visit& visit);
  // Leaves out the sides that are not to be seen.
  void Cull(const SkinModel::Part& part, Side side) const;

  const GlFunctions* gl_ = nullptr;
  // Programs by Surface and finish, compiled when first needed.
  std::array<std::optional<ShaderProgram>, 3 * kNumFinishes> lit_;
  std::array<std::optional<ShaderProgram>, 3> depth_;
  std::vector<std::unique_ptr<SkinBuffers>> buffers_;
  std::vector<Posed> posed_;
  std::vector<SkinnedVertex> vertices_;
  bool has_ghosts_ = false;
};

}  // namespace hazumi::render
