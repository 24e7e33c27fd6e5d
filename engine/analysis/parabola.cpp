// Least squares of z = c0 + c1 s + c2 s^2 and x, y = c0 + c1 s, where s runs from -1 to 1 over the
// fitted frames: well conditioned whatever the times.
//
// The residuals of captures are not independent: skin, markers and a skeleton's errors change
// slowly. The standard error is that of independent ones times sqrt((1 + r)/(1 - r)), r their
// autocorrelation at one frame (the effective number of samples of a first-order process).

#include "engine/analysis/parabola.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"

namespace hazumi {

namespace {

double Correlation(const VecX& residuals) {
  const double square = residuals.squaredNorm();
  if (square == 0.0) return 0.0;
  const auto n = residuals.size();
  const double r = residuals.head(n - 1).dot(residuals.tail(n - 1)) / square;
  return std::clamp(r, 0.0, 0.95);
}

double Rms(const MatX& residuals) {
  return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.rows()));
}

// Of the coefficient of s^2.
double StandardError(const MatX& powers, const VecX& residuals) {
  const double freedom = static_cast<double>(residuals.size()) - 3.0;
  const double r = Correlation(residuals);
  const Mat3 inverse = (powers.transpose() * powers).inverse();
  const double variance = residuals.squaredNorm() / freedom * inverse(2, 2);
  return std::sqrt(variance * (1.0 + r) / (1.0 - r));
}

}  // namespace

Vec3 Parabola::PositionAt(double t) const {
  const double u = t - apex_time;
  return apex + u * horizontal_v - 0.5 * gravity * u * u * Vec3::UnitZ();
}

Vec3 Parabola::VelocityAt(double t) const {
  return horizontal_v - gravity * (t - apex_time) * Vec3::UnitZ();
}

Parabola FitParabola(const std::vector<Vec3>& com, double frame_time, int first, int last) {
  const int n = last - first + 1;
  HAZUMI_DEMAND(n >= 4);
  const double half = 0.5 * (n - 1) * frame_time;  // [s] where s goes from 0 to 1
  const double middle = first * frame_time + half;
  MatX powers(n, 3), p(n, 3);
  for (int i = 0; i < n; ++i) {
    const double s = 2.0 * i / (n - 1) - 1.0;
    powers.row(i) << 1.0, s, s * s;
    p.row(i) = com[first + i];
  }
  const VecX z = powers.householderQr().solve(p.col(2));
  const MatX xy = powers.leftCols(2).householderQr().solve(p.leftCols(2));
  const VecX residuals = p.col(2) - powers * z;

  Parabola fit;
  fit.gravity = -2.0 * z[2] / (half * half);
  fit.gravity_error = 2.0 * StandardError(powers, residuals) / (half * half);
  fit.rms = Rms(residuals);
  fit.horizontal_rms = Rms(p.leftCols(2) - powers.leftCols(2) * xy);
  fit.sagitta = -z[2];
  const double s_apex = z[2] < 0.0 ? -0.5 * z[1] / z[2] : 0.0;
  fit.apex_time = middle + s_apex * half;
  fit.apex.head<2>() = (xy.row(0) + s_apex * xy.row(1)).transpose();
  fit.apex.z() = z[0] + s_apex * (z[1] + s_apex * z[2]);
  fit.horizontal_v.head<2>() = xy.row(1).transpose() / half;
  return fit;
}

}  // namespace hazumi
