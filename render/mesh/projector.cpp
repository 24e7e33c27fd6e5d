#include "render/mesh/projector.h"

#include <Eigen/Geometry>

namespace hazumi::render {
namespace {

using Vec4 = Eigen::Vector4d;

// Where the segment crosses w = w_cut.
Vec4 CutAt(const Vec4& from, const Vec4& to, double w_cut) {
  const double t = (w_cut - from.w()) / (to.w() - from.w());
  return from + t * (to - from);
}

}  // namespace

Projector::Projector(const Camera& camera, PictureSize size)
    : clip_from_world_(ProjectionMatrix(camera, double(size.width) / size.height) *
                       ViewMatrix(camera)),
      size_(size),
      near_m_(camera.near_m) {}

ScreenPoint Projector::ToScreen(const Vec4& clip) const {
  const Vec3 ndc = clip.head<3>() / clip.w();
  return {{0.5 * (ndc.x() + 1.0) * size_.width, 0.5 * (ndc.y() + 1.0) * size_.height}, ndc.z()};
}

std::vector<std::vector<ScreenPoint>> Projector::ProjectLine(
    const std::vector<Vec3>& points) const {
  std::vector<std::vector<ScreenPoint>> pieces;
  Vec4 before = Vec4::Zero();
  bool was_seen = false;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec4 clip = clip_from_world_ * points[i].homogeneous();
    const bool is_seen = clip.w() > near_m_;
    if (is_seen && !was_seen) pieces.emplace_back();
    if (i > 0 && is_seen != was_seen) {
      pieces.back().push_back(ToScreen(CutAt(before, clip, near_m_)));
    }
    if (is_seen) pieces.back().push_back(ToScreen(clip));
    before = clip, was_seen = is_seen;
  }
  return pieces;
}

}  // namespace hazumi::render
