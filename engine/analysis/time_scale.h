#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/gravity_estimate.h"

namespace hazumi {

// What the flights say of a clip's units of time and length.
enum class TimeVerdict {
  kUnknown,         // there is no flight to judge by, or too short ones, or no gravity
  kTrue,            // gravity is right
  kWrongFrameTime,  // the clip plays fast or slow
  kWrongLength,     // lengths are too great or too small; they were a guess
};

struct TimeScale {
  TimeVerdict verdict = TimeVerdict::kUnknown;
  double gravity = 0.0;        // implied by all flights [m/s^2]
  double gravity_error = 0.0;  // standard error [m/s^2]
  Range gravity_range;         // with 95 % confidence [m/s^2]
  double true_gravity = 9.81;  // [m/s^2]
  double frame_time = 0.0;     // as stated [s]
  // If lengths are right: the clip plays at this speed (1 is natural), and its frames are this far
  // apart [s].
  double speed = 1.0;
  double true_frame_time = 0.0;
  // The common frame rate nearest to it, within 5 % [1/s].
  std::optional<int> frame_rate;
  // If the frame time is right: lengths times this are true.
  double length_factor = 1.0;
  double stature = 0.0;   // as stated [m]
  bool is_human = false;  // with the lengths that gravity calls for the figure is 0.8 to 2.3 m tall
  bool scale_known = true;
};

// A verdict is given only where the interval can bear it. Wrong: it does not contain the true
// gravity, and the estimate is more than 10 % off, so that a skeleton that is only about right
// raises no alarm. True: not wrong, and all of the interval is within 25 %. Else unknown. Where the
// unit of length was guessed, and the figure would still be from 0.8 to 2.3 m tall, the lengths are
// held wrong, else the time.
TimeScale JudgeTime(const std::vector<GravityEstimate>& flights, double frame_time, double stature,
                    bool scale_known, double true_gravity);

// With 95 % confidence, of TimeScale's numbers of these names: what a factor's square root or its
// inverse make of the gravity's range. `high` is infinite where the flights do not bound it.
Range SpeedRange(const TimeScale& time);
Range FrameTimeRange(const TimeScale& time);
Range LengthFactorRange(const TimeScale& time);

}  // namespace hazumi
