#include "render/mesh/picture_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hazumi::render {
namespace {

constexpr size_t kMostAreas = 3;  // each is drawn by itself

// `ndc` as a border between pixels, moved by `extra` of them, inside of the picture.
int Border(double ndc, int pixels, int extra) {
  const double at = 0.5 * (ndc + 1.0) * pixels;
  const double border = (extra < 0 ? std::floor(at) : std::ceil(at)) + extra;
  return static_cast<int>(std::clamp(border, 0.0, static_cast<double>(pixels)));
}

PictureArea Union(const PictureArea& a, const PictureArea& b) {
  return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
          std::max(a.top, b.top)};
}

bool Overlap(const PictureArea& a, const PictureArea& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

// The pair that is to become one: two that overlap, else, of too many, those that grow least.
std::pair<size_t, size_t> PairToMerge(const std::vector<PictureArea>& areas) {
  std::pair<size_t, size_t> best{0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < areas.size(); ++i) {
    for (size_t j = i + 1; j < areas.size(); ++j) {
      if (Overlap(areas[i], areas[j])) return {i, j};
      const double more =
          Union(areas[i], areas[j]).pixels() - areas[i].pixels() - areas[j].pixels();
      if (areas.size() > kMostAreas && more < least) least = more, best = {i, j};
    }
  }
  return best;
}

// The pieces of the rows from `bottom` to `top` that no hole covers; each hole has all of these
// rows or none.
void AppendRows(int bottom, int top, const std::vector<PictureArea>& holes, int width,
                std::vector<PictureArea>* areas) {
  int left = 0;
  for (const PictureArea& hole : holes) {
    if (hole.bottom > bottom || hole.top < top) continue;
    if (hole.left > left) areas->push_back({left, bottom, hole.left, top});
    left = hole.right;
  }
  if (left < width) areas->push_back({left, bottom, width, top});
}

}  // namespace

PictureBounds::PictureBounds(const Projector& projector)
    : clip_from_world_(projector.clip_from_world().cast<float>()),
      size_(projector.size()),
      near_m_(static_cast<float>(projector.near_m())),
      least_w_(std::numeric_limits<float>::infinity()),
      min_(Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity())),
      max_(-min_) {}

void PictureBounds::Include(const Eigen::Vector3f& point) {
  const Eigen::Vector4f clip = clip_from_world_ * point.homogeneous();
  if (!(clip.w() > near_m_)) {
    is_before_viewer_ = false;
    return;
  }
  least_w_ = std::min(least_w_, clip.w());
  const Eigen::Vector2f at = clip.head<2>() / clip.w();
  min_ = min_.cwiseMin(at);
  max_ = max_.cwiseMax(at);
}

void PictureBounds::Include(const Vec3& center, double radius) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    Include((center + radius * side).cast<float>());
  }
}

PictureArea PictureBounds::area() const {
  if (!is_before_viewer_) return {0, 0, size_.width, size_.height};
  if (!(min_.x() <= max_.x() && min_.y() <= max_.y())) return {};
  return {Border(min_.x(), size_.width, -1), Border(min_.y(), size_.height, -1),
          Border(max_.x(), size_.width, 1), Border(max_.y(), size_.height, 1)};
}

// The picture is 2 high, and y is the second row of the clip matrix times the point, over w.
double PictureBounds::pixels_per_m() const {
  if (!is_before_viewer_) return std::numeric_limits<double>::infinity();
  const float across = clip_from_world_.row(1).head<3>().norm();
  return static_cast<double>(0.5f * static_cast<float>(size_.height) * across / least_w_);
}

std::vector<PictureArea> AreasOfEdges(const Scene& scene, const Projector& projector) {
  std::vector<PictureArea> areas;
  for (const TaperedCapsule& c : scene.capsules) {
    PictureBounds bounds(projector);
    bounds.Include(c.a, c.radius_a);
    bounds.Include(c.b, c.radius_b);
    areas.push_back(bounds.area());
  }
  for (const Ellipsoid& e : scene.ellipsoids) {
    PictureBounds bounds(projector);
    bounds.Include(e.X_WE.p, e.half_axes.maxCoeff());
    areas.push_back(bounds.area());
  }
  for (const BoxShape& b : scene.boxes) {
    PictureBounds bounds(projector);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      bounds.Include((b.X_WB * Vec3(b.half_size.cwiseProduct(side))).cast<float>());
    }
    areas.push_back(bounds.area());
  }
  for (const Marker& m : scene.markers) {
    PictureBounds bounds(projector);
    bounds.Include(m.center, m.radius_m);
    const bool is_filled = m.shape == MarkerShape::kDisc || m.shape == MarkerShape::kCenterOfMass;
    if (is_filled) areas.push_back(bounds.area());
  }
  return areas;
}

std::vector<PictureArea> Merged(std::vector<PictureArea> areas) {
  std::erase_if(areas, [](const PictureArea& area) { return area.is_empty(); });
  for (;;) {
    const auto [i, j] = PairToMerge(areas);
    if (i == j) return areas;
    areas[i] = Union(areas[i], areas[j]);
    areas.erase(areas.begin() + static_cast<std::ptrdiff_t>(j));
  }
}

std::vector<PictureArea> AreasAround(const std::vector<PictureArea>& holes, PictureSize size) {
  std::vector<PictureArea> from_left = holes;
  std::sort(from_left.begin(), from_left.end(),
            [](const PictureArea& a, const PictureArea& b) { return a.left < b.left; });
  std::vector<int> rows{0, size.height};
  for (const PictureArea& hole : holes) rows.insert(rows.end(), {hole.bottom, hole.top});
  std::sort(rows.begin(), rows.end());
  std::vector<PictureArea> areas;
  for (size_t i = 0; i + 1 < rows.size(); ++i) {
    if (rows[i] < rows[i + 1]) {
      AppendRows(rows[i], rows[i + 1], from_left, size.width, &areas);
    }
  }
  return areas;
}

}  // namespace hazumi::render
