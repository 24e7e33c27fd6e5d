#include "engine/solve/turn_vector.h"

#include <Eigen/Geometry>
#include <cmath>

namespace hazumi::solve {

Mat3 CrossMatrix(const Vec3& r) {
  Mat3 cross;
  cross << 0.0, -r.z(), r.y(), r.z(), 0.0, -r.x(), -r.y(), r.x(), 0.0;
  return cross;
}

Mat3 RotationBy(const Vec3& r) {
  const double a2 = r.squaredNorm(), a = std::sqrt(a2);
  constexpr double kSmall = 1e-4;  // the series' next terms are below rounding
  const double s = a < kSmall ? 1.0 - a2 / 6.0 : std::sin(a) / a;
  const double half = std::sin(0.5 * a);
  const double c = a < kSmall ? 0.5 - a2 / 24.0 : 2.0 * half * half / a2;
  const Mat3 cross = CrossMatrix(r);
  return Mat3::Identity() + s * cross + c * (cross * cross);
}

Vec3 TurnVector(const Mat3& R) {
  const Vec3 twice(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double sine = 0.5 * twice.norm(), cosine = 0.5 * (R.trace() - 1.0);
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-3) return 0.5 * angle / sine * twice;
  if (cosine > 0.0) return (0.5 + angle * angle / 12.0) * twice;
  const Eigen::AngleAxisd turn(R);  // near half a turn the difference says little
  return turn.angle() * turn.axis();
}

Mat3 TurnVectorChange(const Vec3& r) {
  const double a2 = r.squaredNorm(), a = std::sqrt(a2);
  const double c = a < 1e-2 ? 1.0 / 12.0 + a2 / 720.0 + a2 * a2 / 30240.0
                            : (1.0 - 0.5 * a * std::cos(0.5 * a) / std::sin(0.5 * a)) / a2;
  const Mat3 cross = CrossMatrix(r);
  return Mat3::Identity() + 0.5 * cross + c * (cross * cross);
}

}  // namespace hazumi::solve
