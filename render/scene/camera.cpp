#include "render/scene/camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace hazumi::render {
namespace {

// A direction to call up that is not parallel to `forward`.
Vec3 UsableUp(const Vec3& forward, const Vec3& up) {
  for (const Vec3& candidate : {up, Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX())}) {
    if (forward.cross(candidate).norm() > 1e-6 * candidate.norm()) return candidate;
  }
  return Vec3::UnitZ();
}

}  // namespace

Mat4 ViewMatrix(const Camera& camera) {
  const Vec3 forward = (camera.target - camera.eye).normalized();
  const Vec3 right = forward.cross(UsableUp(forward, camera.up)).normalized();
  Mat3 R_EW;
  R_EW << right.transpose(), right.cross(forward).transpose(), -forward.transpose();
  Mat4 view = Mat4::Identity();
  view.topLeftCorner<3, 3>() = R_EW;
  view.topRightCorner<3, 1>() = -(R_EW * camera.eye);
  return view;
}

Mat4 ProjectionMatrix(const Camera& camera, double aspect) {
  const double scale = 1.0 / std::tan(camera.vertical_fov_deg * std::numbers::pi / 360.0);
  const double depth = camera.near_m - camera.far_m;
  Mat4 projection = Mat4::Zero();
  projection(0, 0) = scale / aspect;
  projection(1, 1) = scale;
  projection(2, 2) = (camera.near_m + camera.far_m) / depth;
  projection(2, 3) = 2.0 * camera.near_m * camera.far_m / depth;
  projection(3, 2) = -1.0;
  return projection;
}

}  // namespace hazumi::render
