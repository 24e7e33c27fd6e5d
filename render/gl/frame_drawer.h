#pragma once

#include "render/gl/draw_targets.h"
#include "render/gl/ground_pass.h"
#include "render/gl/lighting.h"
#include "render/gl/picture_pass.h"
#include "render/gl/renderer.h"
#include "render/gl/shadow_map.h"
#include "render/gl/skin_pass.h"
#include "render/gl/vertex_stream.h"
#include "render/mesh/mark_mesh.h"
#include "render/mesh/solid_mesh.h"

namespace hazumi::render {

// The passes of a frame and the GL objects they need.
class FrameDrawer {
 public:
  FrameDrawer(const GlFunctions& gl, const RendererOptions& options);

  // Makes the buffers for pictures of this size; false if the driver cannot.
  bool Resize(PictureSize size);
  // `framebuffer` has colour and depth.
  void Draw(const Scene& scene, GLuint framebuffer);

 private:
  FrameView LookAt(const Scene& scene, const std::vector<BoundingSphere>& casters) const;
  std::vector<PictureArea> Upload(const Scene& scene, const std::vector<BoundingSphere>& casters);
  void UploadSolids(const Scene& scene, SolidKind kind, VertexStream& stream);
  std::vector<PictureArea> CrispAreas(std::vector<PictureArea> edges) const;
  void DrawShadowMap(const ShadowView& shadow);
  void DrawAround(const std::vector<PictureArea>& crisp, const Scene& scene, const FrameView& view,
                  GLuint framebuffer);
  void DrawWithin(const std::vector<PictureArea>& crisp, const Scene& scene, const FrameView& view);
  void DrawSolids(const Scene& scene, const FrameView& view, SolidKind kind);
  void DrawSurroundings(const Scene& scene, const FrameView& view);
  void DrawGhosts(const Scene& scene, const FrameView& view);
  void DrawFlat(const VertexStream& stream, bool hidden_by_solids);

  const GlFunctions& gl_;
  RendererOptions options_;
  ShaderProgram solid_, depth_, sky_, flat_;
  VertexStream solids_, ghosts_, sky_stream_, hidden_marks_, top_marks_, captions_;
  SolidMesh solid_mesh_;
  SkinPass skins_;
  PicturePass pictures_;
  GroundPass ground_;
  ShadowMap shadow_map_;
  PictureTarget target_;
};

}  // namespace hazumi::render
