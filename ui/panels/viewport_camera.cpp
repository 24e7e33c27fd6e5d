#include <cmath>

#include "ui/panels/viewport_state.h"

namespace hazumi::ui {

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
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    const double half = std::tan(0.5 * camera.vertical_fov_deg * kDegree) / kFar;
    camera.vertical_fov_deg = 2.0 * std::atan(half) / kDegree;
    camera.near_m = 0.5 * distance;
  }
  // Straight from above, the top of the picture is where the view came from.
  if (level < 1e-6) camera.up = Vec3(-std::cos(orbit.azimuth), -std::sin(orbit.azimuth), 0.0);
  return camera;
}

}  // namespace hazumi::ui
