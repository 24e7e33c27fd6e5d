// Gravity is a length over a time squared. A clip whose frames are f s apart and are said to be F s
// apart has gravity g' = g (f/F)^2: f = F sqrt(g'/g). One whose lengths are k times too great has
// g' = k g. Which of them it is, the parabola does not say.

#include "engine/analysis/time_scale.h"

#include <array>
#include <cmath>

namespace hazumi {

namespace {

// The mean, weighted by errors. Systematic ones (masses, the skeleton) are 2 % at least, so that
// no flight counts for certain.
GravityEstimate Mean(const std::vector<GravityEstimate>& flights) {
  constexpr double kSystematic = 0.02;
  double weights = 0.0, sum = 0.0;
  for (const GravityEstimate& flight : flights) {
    const double error = std::hypot(flight.error, kSystematic * flight.gravity);
    weights += 1.0 / (error * error);
    sum += flight.gravity / (error * error);
  }
  return {sum / weights, 1.0 / std::sqrt(weights)};
}

std::optional<int> NearestRate(double frame_time) {
  constexpr std::array kRates = {24, 25, 30, 60, 100, 120, 240};
  constexpr double kNear = 0.05;
  std::optional<int> nearest;
  double best = std::log1p(kNear);
  for (const int rate : kRates) {
    const double distance = std::abs(std::log(frame_time * rate));
    if (distance > best) continue;
    best = distance;
    nearest = rate;
  }
  return nearest;
}

}  // namespace

TimeScale JudgeTime(const std::vector<GravityEstimate>& flights, double frame_time, double stature,
                    bool scale_known, double true_gravity) {
  constexpr double kRight = 0.1;
  constexpr double kShortest = 0.8, kTallest = 2.3;  // plausible people [m]
  TimeScale time;
  time.true_gravity = true_gravity;
  time.frame_time = time.true_frame_time = frame_time;
  time.stature = stature;
  time.scale_known = scale_known;
  if (flights.empty() || !(true_gravity > 0.0)) return time;
  const GravityEstimate mean = Mean(flights);
  time.gravity = mean.gravity;
  time.gravity_error = mean.error;
  time.speed = std::sqrt(mean.gravity / true_gravity);
  time.true_frame_time = frame_time * time.speed;
  time.frame_rate = NearestRate(time.true_frame_time);
  time.length_factor = true_gravity / mean.gravity;
  const double true_stature = stature * time.length_factor;
  time.is_human = true_stature >= kShortest && true_stature <= kTallest;
  time.verdict = std::abs(mean.gravity / true_gravity - 1.0) <= kRight ? TimeVerdict::kTrue
                 : !scale_known && time.is_human                       ? TimeVerdict::kWrongLength
                                                 : TimeVerdict::kWrongFrameTime;
  return time;
}

}  // namespace hazumi
