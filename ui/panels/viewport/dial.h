#pragma once

#include <optional>

#include "ui/panels/viewport/camera.h"

namespace hazumi::ui {

// Degrees by the mouse: it is led around a point, or along the tangent of a ring that is seen from
// its edge.
class Dial {
 public:
  explicit Dial(Point pivot) : pivot_(pivot) {}
  // About an axis, taken hold of at `taken_at` [m].
  Dial(const View& view, const Vec3& center, const Vec3& axis, const Vec3& taken_at);

  bool is_tangential() const { return tangent_.has_value(); }
  void BeginAt(Point mouse) { mouse_ = mouse; }
  bool has_begun() const { return mouse_.has_value(); }
  // Keeps what another one has turned so far, and its mouse.
  void GoOnFrom(const Dial& other);
  void Move(Point by);
  // So far: counter-clockwise on the screen, or about the axis of a ring seen from its edge.
  double degrees() const { return degrees_; }
  // To the nearest five, as with Ctrl.
  double snapped_degrees() const;

 private:
  Point pivot_;
  std::optional<Point> tangent_;  // pixels per radian
  std::optional<Point> mouse_;
  double degrees_ = 0.0;
};

}  // namespace hazumi::ui
