#pragma once

#include <array>
#include <memory>
#include <vector>

#include "render/gl/lighting.h"
#include "render/gl/skin_buffers.h"
#include "render/mesh/solid_mesh.h"

namespace hazumi::render {

// Draws the skins of a frame, in the passes of the other solids.
class SkinPass {
 public:
  SkinPass() = default;
  explicit SkinPass(const GlFunctions& gl) : gl_(&gl) {}

  // Poses the scene's skins, and frees what belonged to skins that nobody has any more.
  void Upload(const Scene& scene);
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
  };
  using Surface = SkinModel::Surface;
  enum class Side { kSeen, kAway };  // of closed surfaces

  SkinBuffers& BuffersOf(const std::shared_ptr<const SkinModel>& model);
  void Compile();
  void DrawDepth(SolidKind kind, Side side, const Mat4& clip_from_world);
  template <typename Visit>
  void ForEachPart(SolidKind kind, Surface surface, Side side, const Visit& visit);
  // Leaves out the sides that are not to be seen.
  void Cull(const SkinModel::Part& part, Side side) const;

  const GlFunctions* gl_ = nullptr;
  std::array<ShaderProgram, 3> lit_, depth_;  // by Surface; compiled for the first skin
  bool is_compiled_ = false;
  std::vector<std::unique_ptr<SkinBuffers>> buffers_;
  std::vector<Posed> posed_;
  std::vector<SkinnedVertex> vertices_;
  bool has_ghosts_ = false;
};

}  // namespace hazumi::render
