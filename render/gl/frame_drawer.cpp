// A frame, in order: shadow map; opaque solids; ground; sky where nothing is yet; pictures; marks;
// ghosts; marks on top; text. A picture behind everything goes, with ground and sky, before solids.
// Only solids and filled markers have edges that need several samples a pixel (ground, sky and
// lines are smoothed by what they compute themselves). Around their areas the rest is drawn with
// one sample; the areas themselves with several, which are then averaged into them.

#include "render/gl/frame_drawer.h"

#include <utility>

#include "render/gl/shaders.h"
#include "render/gl/sky_mesh.h"
#include "render/text/text_mesh.h"

namespace hazumi::render {
namespace {

constexpr double kLargeArea = 0.8;         // of the picture: then all of it has several samples
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
      solids_(gl, {3, 3, 4}),
      ghosts_(gl, {3, 3, 4}),
      sky_stream_(gl, {2, 3}),
      hidden_marks_(gl, {3, 2, 4}),
      top_marks_(gl, {3, 2, 4}),
      captions_(gl, {3, 2, 4}),
      skins_(gl),
      pictures_(gl),
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
  const std::vector<PictureArea> crisp = CrispAreas(Upload(scene, casters));
  gl_.Enable(GL_DEPTH_TEST);
  DrawShadowMap(view.shadow);
  gl_.BindTexture(GL_TEXTURE_2D, shadow_map_.texture());
  DrawAround(crisp, scene, view, framebuffer);
  DrawWithin(crisp, scene, view);
  for (const PictureArea& area : crisp) target_.ResolveTo(framebuffer, area);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  DrawFlat(captions_, false);
}

// Returns the areas of sharp edges.
std::vector<PictureArea> FrameDrawer::Upload(const Scene& scene,
                                             const std::vector<BoundingSphere>& casters) {
  const PictureSize size = target_.size();
  const Projector projector(scene.camera, size);
  const MarkMeshes marks = BuildMarks(scene, projector);
  hidden_marks_.Upload(marks.hidden_by_solids);
  top_marks_.Upload(marks.on_top);
  captions_.Upload(BuildCaptions(scene.captions, size));
  sky_stream_.Upload(BuildSky(scene, size));
  pictures_.Upload(scene, projector.clip_from_world(),
                   static_cast<double>(size.width) / size.height);
  ground_.Upload(scene, ShadedGround(casters, scene.to_light, scene.ground.height));
  UploadSolids(scene, SolidKind::kOpaque, solids_);
  UploadSolids(scene, SolidKind::kGhost, ghosts_);
  std::vector<PictureArea> areas = skins_.Upload(scene, projector);
  const std::vector<PictureArea> others = AreasOfEdges(scene, projector);
  areas.insert(areas.end(), others.begin(), others.end());
  return areas;
}

void FrameDrawer::UploadSolids(const Scene& scene, SolidKind kind, VertexStream& stream) {
  solid_mesh_.Clear();
  AppendSolids(scene, kind, DetailOf(scene.camera, target_.size()), solid_mesh_);
  stream.Upload(solid_mesh_.vertices);
  stream.UploadIndices(solid_mesh_.indices);
}

// Where several samples a pixel are needed, or the whole picture if that is about as much.
std::vector<PictureArea> FrameDrawer::CrispAreas(std::vector<PictureArea> edges) const {
  const PictureArea whole{0, 0, target_.size().width, target_.size().height};
  std::vector<PictureArea> areas = Merged(std::move(edges));
  double pixels = 0.0;
  for (const PictureArea& area : areas) pixels += area.pixels();
  if (options_.samples == 1 || pixels > kLargeArea * whole.pixels()) return {whole};
  return areas;
}

// With one sample a pixel.
void FrameDrawer::DrawAround(const std::vector<PictureArea>& crisp, const Scene& scene,
                             const FrameView& view, GLuint framebuffer) {
  const std::vector<PictureArea> areas = AreasAround(crisp, target_.size());
  if (areas.empty()) return;
  BeginPicture(gl_, framebuffer, target_.size(), scene.sky.horizon);
  gl_.Enable(GL_SCISSOR_TEST);
  for (const PictureArea& area : areas) {
    gl_.Scissor(area.left, area.bottom, area.width(), area.height());
    DrawSurroundings(scene, view);
    pictures_.DrawPlanes();
    DrawFlat(hidden_marks_, true);
    DrawFlat(top_marks_, false);
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

// With several samples a pixel.
void FrameDrawer::DrawWithin(const std::vector<PictureArea>& crisp, const Scene& scene,
                             const FrameView& view) {
  gl_.Enable(GL_SCISSOR_TEST);
  for (const PictureArea& area : crisp) {
    gl_.Scissor(area.left, area.bottom, area.width(), area.height());
    target_.Begin(scene.sky.horizon);
    // What solids hide need not be drawn, unless a picture lies over all of it.
    if (pictures_.has_background()) DrawSurroundings(scene, view);
    DrawSolids(scene, view, SolidKind::kOpaque);
    if (!pictures_.has_background()) DrawSurroundings(scene, view);
    pictures_.DrawPlanes();
    DrawFlat(hidden_marks_, true);
    DrawGhosts(scene, view);
    DrawFlat(top_marks_, false);
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

// Draws the sides away from the light: what faces the light is then never shadowed by itself.
void FrameDrawer::DrawShadowMap(const ShadowView& shadow) {
  shadow_map_.Begin();
  if (!options_.shadow) return;
  skins_.DrawShadow(shadow);
  if (!solids_.has_indices()) return;
  depth_.Use();
  depth_.Set("clip_from_world", shadow.clip_from_world);
  gl_.CullFace(GL_FRONT);
  solids_.DrawIndexedTriangles();
  gl_.CullFace(GL_BACK);
}

void FrameDrawer::DrawSolids(const Scene& scene, const FrameView& view, SolidKind kind) {
  const VertexStream& stream = kind == SolidKind::kGhost ? ghosts_ : solids_;
  if (stream.has_indices()) {
    solid_.Use();
    SetSolidLight(solid_, scene, view);
    solid_.Set("ghost", kind == SolidKind::kGhost ? 1.0f : 0.0f);
    solid_.Set("shadow_map", 0);
    stream.DrawIndexedTriangles();
  }
  skins_.DrawLit(kind, scene, view);
}

void FrameDrawer::DrawSurroundings(const Scene& scene, const FrameView& view) {
  if (scene.ground.visible) ground_.Draw(scene, view);
  sky_.Use();
  sky_stream_.DrawTriangles();
  if (pictures_.has_background()) pictures_.DrawBackground();
}

// First only their depth, then the nearest surface: a ghost does not show its own inside.
void FrameDrawer::DrawGhosts(const Scene& scene, const FrameView& view) {
  if (!ghosts_.has_indices() && !skins_.has_ghosts()) return;
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depth_.Use();
  depth_.Set("clip_from_world", view.clip_from_world);
  if (ghosts_.has_indices()) ghosts_.DrawIndexedTriangles();
  skins_.DrawDepth(SolidKind::kGhost, view.clip_from_world);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.Enable(GL_BLEND);
  DrawSolids(scene, view, SolidKind::kGhost);
  gl_.Disable(GL_BLEND);
}

void FrameDrawer::DrawFlat(const VertexStream& stream, bool hidden_by_solids) {
  if (!stream.has_vertices()) return;
  flat_.Use();
  flat_.Set("depth_shift", hidden_by_solids ? kMarkDepthShift : 0.0f);
  if (!hidden_by_solids) gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Disable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  stream.DrawTriangles();
  gl_.Disable(GL_BLEND);
  gl_.Enable(GL_CULL_FACE);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_DEPTH_TEST);
}

}  // namespace hazumi::render
