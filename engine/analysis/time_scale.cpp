// Gravity is a length over a time squared. A clip whose frames are f s apart and are said to be F s
// apart has gravity g' = g (f/F)^2: f = F sqrt(g'/g). One whose lengths are k times too great has
// g' = k g. Which of them it is, the parabola does not say.

#include "engine/analysis/time_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hazumi {

namespace {

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

bool IsWrong(const TimeScale& time) {
  constexpr double kAboutRight = 0.1;
  return !time.gravity_range.Contains(time.true_gravity) &&
         std::abs(time.gravity / time.true_gravity - 1.0) > kAboutRight;
}

// So that "right" says something.
bool IsNarrow(const TimeScale& time) {
  constexpr double kWide = 1.25;
  return time.gravity_range.low >= time.true_gravity / kWide &&
         time.gravity_range.high <= time.true_gravity * kWide;
}

}  // namespace

TimeScale JudgeTime(const std::vector<GravityEstimate>& flights, double frame_time, double stature,
                    bool scale_known, double true_gravity) {
  constexpr double kShortest = 0.8, kTallest = 2.3;  // plausible people [m]
  TimeScale time;
  time.true_gravity = true_gravity;
  time.frame_time = time.true_frame_time = frame_time;
  time.stature = stature;
  time.scale_known = scale_known;
  if (flights.empty() || !(true_gravity > 0.0)) return time;
  const GravityEstimate mean = MeanGravity(flights);
  time.gravity = mean.gravity;
  time.gravity_error = mean.StandardError();
  time.gravity_range = mean.Interval();
  time.speed = std::sqrt(mean.gravity / true_gravity);
  time.true_frame_time = frame_time * time.speed;
  time.frame_rate = NearestRate(time.true_frame_time);
  time.length_factor = true_gravity / mean.gravity;
  const double true_stature = stature * time.length_factor;
  time.is_human = true_stature >= kShortest && true_stature <= kTallest;
  if (IsWrong(time)) {
    time.verdict =
        !scale_known && time.is_human ? TimeVerdict::kWrongLength : TimeVerdict::kWrongFrameTime;
  } else if (IsNarrow(time)) {
    time.verdict = TimeVerdict::kTrue;
  }
  return time;
}

Range SpeedRange(const TimeScale& time) {
  return {std::sqrt(std::max(time.gravity_range.low, 0.0) / time.true_gravity),
          std::sqrt(time.gravity_range.high / time.true_gravity)};
}

Range FrameTimeRange(const TimeScale& time) {
  const Range speed = SpeedRange(time);
  return {time.frame_time * speed.low, time.frame_time * speed.high};
}

Range LengthFactorRange(const TimeScale& time) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  const Range& gravity = time.gravity_range;
  return {time.true_gravity / gravity.high,
          gravity.low > 0.0 ? time.true_gravity / gravity.low : kUnbounded};
}

}  // namespace hazumi
