// What makes the gravity of a fitted parabola wrong, each as a standard error:
//
// noise      of the points: the residuals' [parabola.cpp], as far as they are seen, by Student's
//            distribution.
// slow       errors of the skeleton and of skin on markers change as slowly as the flight itself;
// the
//            fit takes them for curvature and leaves no residual. An arc over a time T whose middle
//            is off by e has its gravity off by 8 e / T^2. So short flights say little.
// masses     the CoM is computed with masses of a table. Were the share m of a body wrong by dm,
//            it would be off by dm (p - c), p the body's CoM and c the figure's. The fit is linear:
//            of that track it makes the error of gravity. Bodies of one mass (left and right) err
//            together. A leg that kicks makes this large, a figure that keeps its pose 0.
// relative   what is left: lengths of bones, where in a body its CoM is.
//
// Of several flights the first two are independent, the others are the same.

#include "engine/analysis/gravity_estimate.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

constexpr double kMassError = 0.2;          // of a body's mass: tables differ by as much
constexpr double kSlowError = 0.002 / 1.7;  // of the stature
constexpr double kRelative = 0.02;          // of gravity
constexpr double kConfidence = 2.0;         // standard errors on each side: 95 %

double SumOfSquares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

// By how much Student's distribution is wider than the normal one at 95 % (Cornish and Fisher).
double FewSamples(double freedom) { return 1.0 + 1.21 / freedom + 1.44 / (freedom * freedom); }

// By how much flights are further apart than their errors say: at least 1.
double Disagreement(const std::vector<GravityEstimate>& flights, double mean) {
  if (flights.size() < 2) return 1.0;
  double square = 0.0;
  for (const GravityEstimate& flight : flights) {
    square += std::pow((flight.gravity - mean) / flight.StandardError(), 2);
  }
  return std::max(1.0, std::sqrt(square / (static_cast<double>(flights.size()) - 1.0)));
}

// Of errors of masses, or of numbers: the sum over flights, with weights.
template <typename Value>
double Weighted(const std::vector<GravityEstimate>& flights, const std::vector<double>& weights,
                Value value) {
  double sum = 0.0;
  for (size_t f = 0; f < flights.size(); ++f) sum += weights[f] * value(flights[f]);
  return sum;
}

std::vector<double> WeightsOf(const std::vector<GravityEstimate>& flights) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const GravityEstimate& flight : flights) {
    weights.push_back(1.0 / std::pow(flight.StandardError(), 2));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

double GravityEstimate::StandardError() const {
  const double relative = kRelative * gravity;
  return std::sqrt(error * error + SumOfSquares(by_mass) + relative * relative);
}

Range GravityEstimate::Interval() const {
  const double half = kConfidence * StandardError();
  return {gravity - half, gravity + half};
}

GravityEstimate EstimateGravity(const MotionSeries& series, const Parabola& fit, int first,
                                int last) {
  const double duration = (last - first) * series.frame_time;
  const double slow = 8.0 * kSlowError * series.stature / (duration * duration);
  const double noise = FewSamples(last - first - 2) * fit.gravity_error;
  GravityEstimate estimate{fit.gravity, std::hypot(noise, slow), {}};
  for (const auto& shift : series.mass_shifts) {
    const Parabola apart = FitParabola(shift, series.frame_time, first, last);
    estimate.by_mass.push_back(kMassError * apart.gravity);
  }
  return estimate;
}

MassResiduals ResidualsByMass(const MotionSeries& series, int first, int last) {
  MassResiduals residuals;
  for (const auto& shift : series.mass_shifts) {
    const Parabola apart = FitParabola(shift, series.frame_time, first, last);
    residuals.height = std::hypot(residuals.height, kMassError * apart.rms);
    residuals.horizontal = std::hypot(residuals.horizontal, kMassError * apart.horizontal_rms);
  }
  return residuals;
}

GravityEstimate MeanGravity(const std::vector<GravityEstimate>& flights) {
  const std::vector<double> weights = WeightsOf(flights);
  GravityEstimate mean;
  mean.gravity = Weighted(flights, weights, [](const auto& flight) { return flight.gravity; });
  const double wider = Disagreement(flights, mean.gravity);
  for (size_t f = 0; f < flights.size(); ++f) {
    mean.error = std::hypot(mean.error, wider * weights[f] * flights[f].error);
  }
  for (size_t c = 0; c < flights[0].by_mass.size(); ++c) {
    mean.by_mass.push_back(
        Weighted(flights, weights, [c](const auto& flight) { return flight.by_mass[c]; }));
  }
  return mean;
}

}  // namespace hazumi
