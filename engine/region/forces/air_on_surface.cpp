// Force of the air on a surface, with alpha the angle between the surface and the flow u, 0 to 90
// degrees, and N the normal on the lee side:
//   F = rho A |u|^2 (C_L e_L + C_D e_D) / 2,   e_D = u / |u|,   e_L along N - (N . e_D) e_D
// Wings [Dickinson, Lehmann, Sane 1999], alpha in degrees:
//   C_L = 0.225 + 1.58 sin(2.13 alpha - 7.2),   C_D = 1.92 - 1.55 cos(2.04 alpha - 9.82)
// Plates have the drag of a square one across the flow [Hoerner 1965], which is a force along N,
// 1.17 sin alpha, whose lift is 0 at both ends of the range. The C_L of other surfaces is faded to
// 0 within 5 degrees of both ends, with two continuous derivatives, since e_L changes sides there.
// Solver version 1 fades that of plates too.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/region/forces/wind.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

namespace {

constexpr double kRightAngle = 90.0 * kDegree;
constexpr double kFade = 5.0 * kDegree;
constexpr double kPlateDrag = 1.17;

double Fade(double angle) {
  return SmoothStep(std::clamp(std::min(angle, kRightAngle - angle) / kFade, 0.0, 1.0));
}

// Straight lines between the values.
double Looked(const std::vector<double>& values, double angle) {
  if (values.empty()) return 0.0;
  const double last = static_cast<double>(values.size() - 1);
  const double at = std::clamp(angle / kRightAngle, 0.0, 1.0) * last;
  const double below = std::min(std::floor(at), std::max(0.0, last - 1.0));
  const auto i = static_cast<size_t>(below);
  const double next = values[std::min(i + 1, values.size() - 1)];
  return values[i] + (at - below) * (next - values[i]);
}

AirCoefficients Unfaded(const LinkSurface& surface, double angle) {
  if (surface.kind == LinkSurface::Kind::kTable) {
    return {Looked(surface.lift, angle), Looked(surface.drag, angle)};
  }
  if (surface.kind == LinkSurface::Kind::kPlate) {
    const double s = std::sin(angle);
    return {kPlateDrag * s * std::cos(angle), kPlateDrag * s * s};
  }
  return {0.225 + 1.58 * std::sin(2.13 * angle - 7.2 * kDegree),
          1.92 - 1.55 * std::cos(2.04 * angle - 9.82 * kDegree)};
}

}  // namespace

AirCoefficients CoefficientsOf(const LinkSurface& surface, double angle) {
  AirCoefficients coefficients = Unfaded(surface, angle);
  if (surface.is_faded) coefficients.lift *= Fade(angle);
  return coefficients;
}

Vec3 AirOnSurface(const LinkSurface& surface, double density, const Vec3& n, const Vec3& u) {
  const double speed = u.norm();
  if (speed == 0.0) return Vec3::Zero();
  const Vec3 drag = u / speed;
  const double across = n.dot(drag);
  const Vec3 lift = (across < 0.0 ? -1.0 : 1.0) * (n - across * drag);
  const double along = lift.norm();
  const auto [C_L, C_D] = CoefficientsOf(surface, std::atan2(std::abs(across), along));
  const double pressure = 0.5 * density * surface.area * speed * speed;
  return pressure * (C_D * drag + (C_L == 0.0 ? 0.0 : C_L / along) * lift);
}

}  // namespace hazumi
