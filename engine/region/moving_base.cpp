#include "engine/region/moving_base.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

constexpr int kN = 14;

// For samples f at the Chebyshev points of the first kind: `to_chebyshev` f are the coefficients of
// the interpolating Chebyshev series, `to_powers` f those of its powers.
struct Transforms {
  Eigen::Matrix<double, kN, kN> to_chebyshev, to_powers;
  std::array<double, kN> points;

  Transforms() {
    for (int i = 0; i < kN; ++i) points[i] = std::cos(std::numbers::pi * (2 * i + 1) / (2.0 * kN));
    Eigen::Matrix<double, kN, kN> powers = Eigen::Matrix<double, kN, kN>::Zero();  // of T_k: rows
    powers(0, 0) = powers(1, 1) = 1.0;
    for (int k = 2; k < kN; ++k) {
      powers.row(k) = -powers.row(k - 2);
      for (int p = 1; p < kN; ++p) powers(k, p) += 2.0 * powers(k - 1, p - 1);
    }
    for (int k = 0; k < kN; ++k) {
      for (int i = 0; i < kN; ++i) {
        to_chebyshev(k, i) =
            (k ? 2.0 : 1.0) / kN * std::cos(k * std::numbers::pi * (2 * i + 1) / (2.0 * kN));
      }
    }
    to_powers = powers.transpose() * to_chebyshev;
  }
};

const Transforms& TheTransforms() {
  static const Transforms transforms;
  return transforms;
}

}  // namespace

double MovingBase::Point(int i) { return TheTransforms().points[i]; }

void MovingBase::Take(const Frame& frame, int i, Samples* samples) {
  const Eigen::Quaterniond turn(frame.R.eigen());
  auto& to = (*samples)[i];
  const V3 &w = frame.w, &alpha = frame.alpha, &a = frame.a;
  to = {turn.w(), turn.x(), turn.y(), turn.z(), w.x, w.y, w.z,
        alpha.x,  alpha.y,  alpha.z,  a.x,      a.y, a.z, 0.0};
  if (i == 0) return;
  double dot = 0.0;  // q and -q are one rotation
  for (int k = 0; k < 4; ++k) dot += to[k] * (*samples)[i - 1][k];
  for (int k = 0; k < 4 && dot < 0.0; ++k) to[k] = -to[k];
}

double MovingBase::SetFit(const Samples& samples, Fit* fit) {
  constexpr double kRounding = 1e-12;
  using Matrix = Eigen::Matrix<double, kPoints, kValues, Eigen::RowMajor>;
  const Eigen::Map<const Matrix> f(samples[0].data());
  Eigen::Map<Matrix> c(fit->c[0].data());
  c.noalias() = TheTransforms().to_powers.lazyProduct(f);
  const auto tail = (TheTransforms().to_chebyshev.bottomRows<2>().lazyProduct(f)).eval();
  return tail.cwiseAbs().maxCoeff() / (kRounding * (1.0 + f.cwiseAbs().maxCoeff()));
}

// How much longer the next fit may be. The last coefficients go with the length to the 12th and
// 13th power.
double MovingBase::Growth(double left_out, bool is_good) {
  constexpr double kSafety = 0.9;
  if (!std::isfinite(left_out)) return 0.5;
  const double grow = kSafety * std::pow(std::max(left_out, 1e-6), -1.0 / 12.5);
  return is_good ? std::max(0.8, grow) : std::clamp(grow, 0.25, 0.8);
}

const MovingBase::Fit& MovingBase::FitFor(double t) const {
  const auto ends_before = [t](const Fit& fit) { return fit.middle + fit.half < t; };
  const auto fit = std::partition_point(fits_.begin(), fits_.end(), ends_before);
  return fit == fits_.end() ? fits_.back() : *fit;
}

MovingBase::Frame MovingBase::Evaluate(const Fit& fit, double t) {
  const double s = fit.half > 0.0 ? (t - fit.middle) / fit.half : 0.0;
  using Values = Eigen::Array<double, kValues, 1>;
  Values v = Eigen::Map<const Values>(fit.c[kPoints - 1].data());
  for (int p = kPoints - 2; p >= 0; --p) v = v * s + Eigen::Map<const Values>(fit.c[p].data());
  const double w = v[0], x = v[1], y = v[2], z = v[3];
  const double n = 2.0 / (w * w + x * x + y * y + z * z);
  const M3 R{{1.0 - n * (y * y + z * z), n * (x * y + w * z), n * (x * z - w * y)},
             {n * (x * y - w * z), 1.0 - n * (x * x + z * z), n * (y * z + w * x)},
             {n * (x * z + w * y), n * (y * z - w * x), 1.0 - n * (x * x + y * y)}};
  return {R, {v[4], v[5], v[6]}, {v[7], v[8], v[9]}, {v[10], v[11], v[12]}};
}

}  // namespace hazumi
