#include "ui/panels/viewport/dial.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/spatial/degrees.h"

namespace hazumi::ui {

Dial::Dial(const View& view, const Vec3& center, const Vec3& axis, const Vec3& taken_at)
    : pivot_(view.ToWindow(center).value_or(Point{})) {
  constexpr double kEdge = 0.35;
  if (std::abs(axis.dot(view.ToViewer(center))) > kEdge) return;
  const Vec3 along = axis.cross(taken_at - center) / view.MetresPerPixel(center);
  const Point tangent = {static_cast<float>(along.dot(view.right())),
                         static_cast<float>(-along.dot(view.up()))};
  if (std::hypot(tangent.x, tangent.y) >= 1.0f) tangent_ = tangent;
}

double Dial::snapped_degrees() const {
  constexpr double kStep = 5.0;
  return kStep * std::round(degrees_ / kStep);
}

void Dial::GoOnFrom(const Dial& other) {
  mouse_ = other.mouse_;
  degrees_ = other.degrees_;
}

void Dial::Move(Point by) {
  const Point from = *mouse_, to = {from.x + by.x, from.y + by.y};
  mouse_ = to;
  if (tangent_) {
    const double size = std::hypot(tangent_->x, tangent_->y);
    degrees_ += (by.x * tangent_->x + by.y * tangent_->y) / (size * size) / kDegree;
    return;
  }
  const auto angle = [this](Point p) { return std::atan2(pivot_.y - p.y, p.x - pivot_.x); };
  degrees_ += std::remainder(angle(to) - angle(from), 2.0 * std::numbers::pi) / kDegree;
}

}  // namespace hazumi::ui
