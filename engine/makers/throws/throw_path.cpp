// A throw that is to come down on a spot s, rising h above the point p where it is let go, leaves
// with
//   v_z = sqrt(2 g h),  T = (v_z + sqrt(2 g (h + p_z - s_z))) / g,  v_xy = (s - p)_xy / T.
// The slowest one leaves at the angle with tan = (z + sqrt(z^2 + d^2)) / d, where d and z are how
// far away and how much higher the spot is, and with v^2 = g (z + sqrt(z^2 + d^2)).

#include "engine/makers/throws/throw_path.h"

#include <algorithm>
#include <cmath>

#include "engine/collision/distance.h"

namespace hazumi::makers {

double HeightOfSlowestThrow(const Vec3& from, const Vec3& spot, double gravity) {
  const double d = (spot - from).head<2>().norm(), z = spot.z() - from.z();
  const double up = z + std::hypot(z, d);  // d times the tangent of the angle
  const double square = gravity * up, sine_square = up * up / (up * up + d * d + 1e-12);
  return 0.5 * square * sine_square / gravity;
}

ThrowPath ThrowOver(const Vec3& from, const Vec3& spot, double height, double gravity) {
  ThrowPath path;
  path.from = from;
  const double fall = std::max(0.0, height + from.z() - spot.z());
  path.velocity.z() = std::sqrt(2.0 * gravity * height);
  path.seconds = (path.velocity.z() + std::sqrt(2.0 * gravity * fall)) / gravity;
  path.velocity.head<2>() = (spot - from).head<2>() / path.seconds;
  return path;
}

double SecondsDown(const ThrowPath& path, double z, double gravity) {
  const double up = path.velocity.z();
  const double square = up * up + 2.0 * gravity * (path.from.z() - z);
  return std::max(0.0, (up + std::sqrt(std::max(0.0, square))) / gravity);
}

std::string InTheWay(const ThrowPath& path, double radius, const Animation& animation) {
  constexpr double kStep = 0.01, kTouch = 0.01;  // [s, m]
  const Vec3 g(0.0, 0.0, -animation.gravity);
  const auto at = [&](double t) { return Vec3(path.from + t * path.velocity + 0.5 * t * t * g); };
  const Vec3 spot = at(path.seconds);
  for (double t = kStep; t < path.seconds; t += kStep) {
    const Capsule swept = {at(t - kStep), at(t), radius};
    for (const SceneObject& object : animation.scene) {
      if (SignedDistance(swept, object.shape).value > -kTouch) continue;
      if ((at(t) - spot).norm() > radius + 0.05) return object.name;
    }
  }
  return "";
}

}  // namespace hazumi::makers
