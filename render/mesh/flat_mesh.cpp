#include "render/mesh/flat_mesh.h"

#include <algorithm>
#include <cmath>

namespace hazumi::render {
namespace {

constexpr double kClosestPx = 0.34;
constexpr double kLongestMiter = 2.0;  // in half widths
constexpr float kInside = 1e6f;        // half width of what is not smoothed

using Vec2 = Eigen::Vector2d;

FlatVertex MakeVertex(const Vec2& px, double depth, double side, double half_width,
                      const SrgbColor& c, PictureSize size) {
  return {static_cast<float>(2.0 * px.x() / size.width - 1.0),
          static_cast<float>(2.0 * px.y() / size.height - 1.0),
          static_cast<float>(depth),
          static_cast<float>(side),
          static_cast<float>(half_width),
          {c.r, c.g, c.b, c.a}};
}

std::vector<ScreenPoint> Thin(const std::vector<ScreenPoint>& points) {
  std::vector<ScreenPoint> kept;
  for (const ScreenPoint& p : points) {
    if (kept.empty() || (p.px - kept.back().px).norm() >= kClosestPx) kept.push_back(p);
  }
  return kept;
}

Vec2 LeftOf(const Vec2& from, const Vec2& to) {
  const Vec2 along = (to - from).normalized();
  return {-along.y(), along.x()};
}

// From the middle line to the left edge of a stroke of half width 1 at point i.
Vec2 MiterAt(const std::vector<ScreenPoint>& points, size_t i) {
  const size_t last = points.size() - 1;
  const size_t in = i == 0 ? 0 : i - 1, out = i == last ? last - 1 : i;
  const Vec2 after = LeftOf(points[out].px, points[out + 1].px);
  Vec2 before = LeftOf(points[in].px, points[in + 1].px);
  const Vec2 sum = before + after;
  const double length = sum.norm();
  if (length < 1e-6) return before;
  return sum / length * std::min(2.0 / length, kLongestMiter);
}

// Lengthens both ends by half a width, so that they end square around the end points.
void ExtendEnds(std::vector<ScreenPoint>& points, double by_px) {
  const Vec2 head = (points[0].px - points[1].px).normalized();
  const size_t n = points.size();
  const Vec2 tail = (points[n - 1].px - points[n - 2].px).normalized();
  points[0].px += by_px * head;
  points[n - 1].px += by_px * tail;
}

}  // namespace

void AppendStroke(const std::vector<ScreenPoint>& points, const Stroke& stroke, PictureSize size,
                  FlatMesh& mesh) {
  std::vector<ScreenPoint> line = Thin(points);
  if (line.size() < 2) return;
  const double half = 0.5 * stroke.width_px, outer = half + 1.0;
  ExtendEnds(line, half);
  FlatVertex left{}, right{};
  for (size_t i = 0; i < line.size(); ++i) {
    const Vec2 miter = outer * MiterAt(line, i);
    const ScreenPoint& p = line[i];
    const auto next_left = MakeVertex(p.px + miter, p.depth, outer, half, stroke.color, size);
    const auto next_right = MakeVertex(p.px - miter, p.depth, -outer, half, stroke.color, size);
    if (i > 0) {
      mesh.insert(mesh.end(), {left, right, next_left, right, next_right, next_left});
    }
    left = next_left, right = next_right;
  }
}

void AppendFill(const std::vector<ScreenPoint>& corners, const SrgbColor& color, PictureSize size,
                FlatMesh& mesh) {
  const auto vertex = [&](const ScreenPoint& p) {
    return MakeVertex(p.px, p.depth, 0.0, kInside, color, size);
  };
  for (size_t i = 2; i < corners.size(); ++i) {
    mesh.insert(mesh.end(), {vertex(corners[0]), vertex(corners[i - 1]), vertex(corners[i])});
  }
}

}  // namespace hazumi::render
