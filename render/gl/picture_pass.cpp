#include "render/gl/picture_pass.h"

#include <algorithm>
#include <array>
#include <utility>

#include "render/gl/shaders.h"

namespace hazumi::render {

namespace {

// Those before it belong to the shadow map, the ground and skins.
constexpr GLenum kPictureUnit = GL_TEXTURE3;

struct ScreenCorner {
  float clip[4];
  float u, v;  // from the picture's upper left corner
};

constexpr std::array<std::array<float, 2>, 6> kCorners = {
    {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};  // from the lower left one

ScreenCorner CornerAt(const Eigen::Vector4d& clip, const std::array<float, 2>& place) {
  return {{static_cast<float>(clip[0]), static_cast<float>(clip[1]), static_cast<float>(clip[2]),
           static_cast<float>(clip[3])},
          place[0],
          1.0f - place[1]};
}

std::vector<ScreenCorner> CornersOf(const PicturePlane& plane, const Mat4& clip_from_world,
                                    double aspect) {
  const double own = static_cast<double>(plane.image->width) / plane.image->height;
  const double half_x = std::min(1.0, own / aspect), half_y = std::min(1.0, aspect / own);
  std::vector<ScreenCorner> corners;
  for (const auto& place : kCorners) {
    const double a = place[0], b = place[1];
    const Vec3 at = plane.corner + a * plane.right + b * plane.up;
    const Eigen::Vector4d in_world = clip_from_world * at.homogeneous();
    const Eigen::Vector4d behind((2.0 * a - 1.0) * half_x, (2.0 * b - 1.0) * half_y, 1.0, 1.0);
    corners.push_back(CornerAt(plane.is_background ? behind : in_world, place));
  }
  return corners;
}

GlTexture Uploaded(const GlFunctions& gl, const Image& image) {
  GlTexture texture(gl);
  gl.ActiveTexture(kPictureUnit);
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                image.rgba.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.ActiveTexture(GL_TEXTURE0);
  return texture;
}

}  // namespace

PicturePass::Shown PicturePass::Taken(const std::shared_ptr<const Image>& image) {
  for (Shown& old : shown_) {
    if (old.image == image) return std::move(old);
  }
  return {image, Uploaded(*gl_, *image), VertexStream(*gl_, {4, 2})};
}

void PicturePass::Upload(const Scene& scene, const Mat4& clip_from_world, double aspect) {
  std::vector<Shown> now;
  for (const PicturePlane& plane : scene.pictures) {
    if (!plane.image || plane.image->width <= 0 || plane.image->height <= 0) continue;
    now.push_back(Taken(plane.image));
    now.back().corners.Upload(CornersOf(plane, clip_from_world, aspect));
    now.back().is_background = plane.is_background;
    now.back().opacity = static_cast<float>(plane.opacity);
  }
  shown_ = std::move(now);
  if (!shown_.empty() && !program_) {
    program_.emplace(*gl_, "", shaders::kPictureVertex, shaders::kPictureFragment);
  }
}

bool PicturePass::has_background() const {
  return std::any_of(shown_.begin(), shown_.end(),
                     [](const Shown& shown) { return shown.is_background; });
}

void PicturePass::DrawBackground() {
  gl_->Disable(GL_DEPTH_TEST);
  for (const Shown& shown : shown_) {
    if (shown.is_background) Draw(shown);
  }
  gl_->Enable(GL_DEPTH_TEST);
}

void PicturePass::DrawPlanes() {
  for (const Shown& shown : shown_) {
    if (!shown.is_background) Draw(shown);
  }
}

void PicturePass::Draw(const Shown& shown) {
  program_->Use();
  program_->Set("opacity", shown.opacity);
  program_->Set("picture_map", 3);
  gl_->ActiveTexture(kPictureUnit);
  gl_->BindTexture(GL_TEXTURE_2D, shown.texture.id());
  gl_->Enable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  shown.corners.DrawTriangles();
  gl_->Enable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
  gl_->ActiveTexture(GL_TEXTURE0);
}

}  // namespace hazumi::render
