#pragma once

#include <optional>
#include <vector>

#include "engine/project/project.h"
#include "ui/panels/viewport/state.h"

namespace hazumi::ui {

// A half line of the world [m]; `direction` is a unit vector.
struct Ray {
  Vec3 from, direction;
};

// A camera and the rectangle of the window that its picture fills: takes points of the world [m]
// to the window [px] and back.
class View {
 public:
  View(const render::Camera& camera, const Rect& rect);

  const Rect& rect() const { return rect_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  const Vec3& back() const { return back_; }  // towards the viewer
  const Vec3& eye() const { return eye_; }

  // None if the point is behind the viewer.
  std::optional<Point> ToWindow(const Vec3& p) const;
  Ray Through(Point at) const;
  double MetresPerPixel(const Vec3& p) const;
  // Where the ray through `at` meets the plane through `p`; none if it runs along the plane.
  std::optional<Vec3> OnPlane(Point at, const Vec3& p, const Vec3& normal) const;
  // From a point to the viewer, unit.
  Vec3 ToViewer(const Vec3& p) const { return (eye_ - p).normalized(); }

 private:
  Rect rect_;
  Vec3 eye_, right_, up_, back_;
  double near_m_, half_height_;  // half_height_: of the picture at a distance of 1
};

// By movements of the mouse [px] in a viewport `height` high.
void Orbit(Point by, OrbitCamera* camera);
// What is as far away as the target stays under the mouse.
void Pan(Point by, float height, OrbitCamera* camera);
// Closer by a factor < 1.
void Zoom(double factor, OrbitCamera* camera);
// Looks at a sphere from where it looks now, so that the sphere fills the picture.
void FrameSphere(const Vec3& center, double radius, double aspect, OrbitCamera* camera);

// The project's camera in a viewport of another shape: its picture, as wide as high times `aspect`,
// lies in `border` with some room around.
struct BorderedCamera {
  render::Camera camera;
  Rect border;
};
BorderedCamera Bordered(const ProjectCamera& camera, double aspect, const Rect& rect);

// What the viewport looks through now.
View ViewOf(const ViewportState& state, const Project& project, const Rect& rect);
render::Camera CameraNow(const ViewportState& state, const Project& project, const Rect& rect);

// "front", "right", ... when looking along an axis; else empty.
const char* SideOf(const OrbitCamera& camera);

inline constexpr double kPictureAspect = 16.0 / 9.0;  // of what `hazumi render` makes by itself

}  // namespace hazumi::ui
