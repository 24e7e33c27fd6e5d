// A frame, in order: shadow map; opaque solids; ground; sky where nothing is yet; marks; ghosts;
// marks on top; samples averaged into the target; text.

#include "render/gl/frame_drawer.h"

#include "render/gl/shaders.h"
#include "render/gl/sky_mesh.h"
#include "render/text/text_mesh.h"

namespace hazumi::render {
namespace {

constexpr float kMarkDepthShift = -2e-5f;  // lifts lines off what they lie on

RendererOptions Sane(RendererOptions options) {
  options.samples = options.samples <= 1 ? 1 : 4;
  if (!options.shadow) options.shadow_map_px = 1;
  return options;
}

MeshDetail DetailOf(const Camera& camera, PictureSize size) {
  return {camera.eye, 0.5 * size.height * ProjectionMatrix(camera, 1.0)(1, 1)};
}

}  // namespace

FrameDrawer::FrameDrawer(const GlFunctions& gl, const RendererOptions& options)
    : gl_(gl),
      options_(Sane(options)),
      solid_(gl, "", shaders::kSolidVertex, shaders::kSolidFragment),
      depth_(gl, "", shaders::kDepthVertex, shaders::kDepthFragment),
      sky_(gl, "", shaders::kSkyVertex, shaders::kSkyFragment),
      flat_(gl, "", shaders::kFlatVertex, shaders::kFlatFragment),
      solid_stream_(gl, {3, 3, 4}),
      sky_stream_(gl, {2, 3}),
      flat_stream_(gl, {3, 2, 4}),
      skins_(gl),
      ground_(gl),
      shadow_map_(gl, options_.shadow_map_px) {
  gl.Enable(GL_CULL_FACE);
  gl.DepthFunc(GL_LEQUAL);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.ActiveTexture(GL_TEXTURE0);
}

bool FrameDrawer::Resize(PictureSize size) {
  if (target_.size().width == size.width && target_.size().height == size.height) return true;
  target_ = PictureTarget(gl_, size, options_.samples);
  return target_.is_complete();
}

FrameView FrameDrawer::LookAt(const Scene& scene,
                              const std::vector<BoundingSphere>& casters) const {
  const int map_px = shadow_map_.size_px();
  return {Projector(scene.camera, target_.size()).clip_from_world(),
          FitShadow(casters, scene.to_light, map_px), 1.0 / map_px};
}

void FrameDrawer::Draw(const Scene& scene, GLuint framebuffer) {
  const std::vector<BoundingSphere> casters = CasterSpheres(scene);
  const FrameView view = LookAt(scene, casters);
  const MarkMeshes marks = BuildMarks(scene, Projector(scene.camera, target_.size()));
  gl_.Enable(GL_DEPTH_TEST);
  UploadSolids(scene, SolidKind::kOpaque);
  skins_.Upload(scene);
  DrawShadowMap(view.shadow);
  target_.Begin(scene.sky.horizon);
  gl_.BindTexture(GL_TEXTURE_2D, shadow_map_.texture());
  DrawSolids(scene, view, false);
  skins_.DrawLit(SolidKind::kOpaque, scene, view);
  DrawSurroundings(scene, view, casters);
  DrawFlat(marks.hidden_by_solids, true);
  DrawGhosts(scene, view);
  DrawFlat(marks.on_top, false);
  target_.ResolveTo(framebuffer);
  DrawFlat(BuildCaptions(scene.captions, target_.size()), false);
}

void FrameDrawer::UploadSolids(const Scene& scene, SolidKind kind) {
  solid_mesh_.Clear();
  AppendSolids(scene, kind, DetailOf(scene.camera, target_.size()), solid_mesh_);
  solid_stream_.Upload(solid_mesh_.vertices);
  solid_stream_.UploadIndices(solid_mesh_.indices);
}

// Draws the sides away from the light: what faces the light is then never shadowed by itself.
void FrameDrawer::DrawShadowMap(const ShadowView& shadow) {
  shadow_map_.Begin();
  if (!options_.shadow) return;
  skins_.DrawShadow(shadow);
  if (solid_mesh_.indices.empty()) return;
  depth_.Use();
  depth_.Set("clip_from_world", shadow.clip_from_world);
  gl_.CullFace(GL_FRONT);
  solid_stream_.DrawIndexedTriangles();
  gl_.CullFace(GL_BACK);
}

void FrameDrawer::DrawSolids(const Scene& scene, const FrameView& view, bool as_ghosts) {
  solid_.Use();
  SetSolidLight(solid_, scene, view);
  solid_.Set("ghost", as_ghosts ? 1.0f : 0.0f);
  solid_.Set("shadow_map", 0);
  solid_stream_.DrawIndexedTriangles();
}

void FrameDrawer::DrawSurroundings(const Scene& scene, const FrameView& view,
                                   const std::vector<BoundingSphere>& casters) {
  if (scene.ground.visible) {
    ground_.Draw(scene, view, ShadedGround(casters, scene.to_light, scene.ground.height));
  }
  sky_.Use();
  sky_stream_.Upload(BuildSky(scene, target_.size()));
  sky_stream_.DrawTriangles();
}

// First only their depth, then the nearest surface: a ghost does not show its own inside.
void FrameDrawer::DrawGhosts(const Scene& scene, const FrameView& view) {
  UploadSolids(scene, SolidKind::kGhost);
  if (solid_mesh_.indices.empty() && !skins_.has_ghosts()) return;
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depth_.Use();
  depth_.Set("clip_from_world", view.clip_from_world);
  solid_stream_.DrawIndexedTriangles();
  skins_.DrawDepth(SolidKind::kGhost, view.clip_from_world);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.Enable(GL_BLEND);
  DrawSolids(scene, view, true);
  skins_.DrawLit(SolidKind::kGhost, scene, view);
  gl_.Disable(GL_BLEND);
}

void FrameDrawer::DrawFlat(const FlatMesh& mesh, bool hidden_by_solids) {
  if (mesh.empty()) return;
  flat_stream_.Upload(mesh);
  flat_.Use();
  flat_.Set("depth_shift", hidden_by_solids ? kMarkDepthShift : 0.0f);
  if (!hidden_by_solids) gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  flat_stream_.DrawTriangles();
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_CULL_FACE);
  gl_.DepthMask(GL_TRUE);
}

}  // namespace hazumi::render
