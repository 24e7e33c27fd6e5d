#include "ui/panels/viewport/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/spatial/degrees.h"

namespace hazumi::ui {

namespace {

constexpr double kNearest = 0.2, kFarthest = 100.0;  // of the target [m]

double HalfHeight(double vertical_fov_deg) { return std::tan(0.5 * vertical_fov_deg * kDegree); }

}  // namespace

render::Camera CameraOf(const OrbitCamera& orbit) {
  render::Camera camera;
  const double level = std::cos(orbit.elevation);
  const Vec3 back(level * std::cos(orbit.azimuth), level * std::sin(orbit.azimuth),
                  std::sin(orbit.elevation));
  constexpr double kFar = 20.0;  // times as far with so much narrower a view: nearly parallel
  const double distance = orbit.is_orthographic ? kFar * orbit.distance : orbit.distance;
  camera.target = orbit.target;
  camera.eye = orbit.target + distance * back;
  if (orbit.is_orthographic) {
    const double half = HalfHeight(camera.vertical_fov_deg) / kFar;
    camera.vertical_fov_deg = 2.0 * std::atan(half) / kDegree;
    camera.near_m = 0.5 * distance;
    camera.far_m = std::max(camera.far_m, 2.0 * distance);
  }
  // Straight from above, the top of the picture is where the view came from.
  if (level < 1e-6) camera.up = Vec3(-std::cos(orbit.azimuth), -std::sin(orbit.azimuth), 0.0);
  return camera;
}

View::View(const render::Camera& camera, const Rect& rect)
    : rect_(rect),
      eye_(camera.eye),
      near_m_(camera.near_m),
      half_height_(HalfHeight(camera.vertical_fov_deg)) {
  const render::Mat4 view = render::ViewMatrix(camera);
  right_ = view.block<1, 3>(0, 0).transpose();
  up_ = view.block<1, 3>(1, 0).transpose();
  back_ = view.block<1, 3>(2, 0).transpose();
}

std::optional<Point> View::ToWindow(const Vec3& p) const {
  const Vec3 from_eye = p - eye_;
  const double depth = -from_eye.dot(back_);
  if (depth < near_m_) return std::nullopt;
  const double px = 0.5 * rect_.h / (half_height_ * depth);
  return Point{static_cast<float>(rect_.x + 0.5 * rect_.w + px * from_eye.dot(right_)),
               static_cast<float>(rect_.y + 0.5 * rect_.h - px * from_eye.dot(up_))};
}

Ray View::Through(Point at) const {
  const double m = 2.0 * half_height_ / rect_.h;
  const double x = m * (at.x - rect_.x - 0.5 * rect_.w), y = m * (rect_.y + 0.5 * rect_.h - at.y);
  return {eye_, (x * right_ + y * up_ - back_).normalized()};
}

double View::MetresPerPixel(const Vec3& p) const {
  return 2.0 * half_height_ * std::max(-(p - eye_).dot(back_), near_m_) / rect_.h;
}

std::optional<Vec3> View::OnPlane(Point at, const Vec3& p, const Vec3& normal) const {
  const Ray ray = Through(at);
  const double along = ray.direction.dot(normal);
  // Neither is so in a view without a size.
  if (!(std::abs(along) >= 1e-3)) return std::nullopt;
  const double distance = (p - ray.from).dot(normal) / along;
  if (!(distance > 0.0)) return std::nullopt;
  return ray.from + distance * ray.direction;
}

void Orbit(Point by, OrbitCamera* camera) {
  camera->azimuth = std::remainder(camera->azimuth - 0.008 * by.x, 2.0 * std::numbers::pi);
  camera->elevation =
      std::clamp(camera->elevation + 0.008 * by.y, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
}

void Pan(Point by, float height, OrbitCamera* camera) {
  const View view(CameraOf(*camera), {0.0f, 0.0f, height, height});
  const double metres = view.MetresPerPixel(camera->target);
  camera->target += metres * (-by.x * view.right() + by.y * view.up());
}

void Zoom(double factor, OrbitCamera* camera) {
  camera->distance = std::clamp(camera->distance * factor, kNearest, kFarthest);
}

void FrameSphere(const Vec3& center, double radius, double aspect, OrbitCamera* camera) {
  const double half = HalfHeight(render::Camera().vertical_fov_deg) * std::min(1.0, aspect);
  camera->target = center;
  camera->distance = std::clamp(radius / std::sin(std::atan(half)), kNearest, kFarthest);
}

BorderedCamera Bordered(const ProjectCamera& camera, double aspect, const Rect& rect) {
  constexpr double kRoom = 0.94;  // of the viewport
  const double height = kRoom * std::min<double>(rect.h, rect.w / aspect);
  BorderedCamera bordered;
  bordered.camera.eye = camera.eye_m;
  bordered.camera.target = camera.target_m;
  const double half = HalfHeight(camera.vertical_fov_deg) * rect.h / height;
  bordered.camera.vertical_fov_deg = 2.0 * std::atan(half) / kDegree;
  const auto w = static_cast<float>(aspect * height), h = static_cast<float>(height);
  bordered.border = {rect.x + 0.5f * (rect.w - w), rect.y + 0.5f * (rect.h - h), w, h};
  return bordered;
}

render::Camera CameraNow(const ViewportState& state, const Project& project, const Rect& rect) {
  if (!state.through_project_camera || !project.camera) return CameraOf(state.camera);
  return Bordered(*project.camera, kPictureAspect, rect).camera;
}

View ViewOf(const ViewportState& state, const Project& project, const Rect& rect) {
  return View(CameraNow(state, project, rect), rect);
}

const char* SideOf(const OrbitCamera& camera) {
  constexpr double kSame = 1e-6;
  const auto looks = [&](double azimuth) {
    return std::abs(std::remainder(camera.azimuth - azimuth, 2.0 * std::numbers::pi)) < kSame;
  };
  if (std::abs(camera.elevation - 0.5 * std::numbers::pi) < kSame) return "Top";
  if (std::abs(camera.elevation) > kSame) return "";
  if (looks(0.0)) return "Front";
  if (looks(std::numbers::pi)) return "Back";
  if (looks(0.5 * std::numbers::pi)) return "Left";
  if (looks(-0.5 * std::numbers::pi)) return "Right";
  return "";
}

}  // namespace hazumi::ui
