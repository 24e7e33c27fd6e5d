#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hazumi {

// What the flights say of a clip's units of time and length.
enum class TimeVerdict {
  kUnknown,         // there is no flight to judge by, or no gravity
  kTrue,            // gravity is right
  kWrongFrameTime,  // the clip plays fast or slow
  kWrongLength,     // lengths are too great or too small; they were a guess
};

struct TimeScale {
  TimeVerdict verdict = TimeVerdict::kUnknown;
  double gravity = 0.0;        // implied by all flights [m/s^2]
  double gravity_error = 0.0;  // standard error [m/s^2]
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

// Of one flight.
struct GravityEstimate {
  double gravity = 0.0, error = 0.0;  // [m/s^2]
};

// Right is what agrees within 10 % (gravity's), so that masses and a skeleton that are only about
// right raise no alarm. Where the unit of length was guessed, and the figure would still be from
// 0.8 to 2.3 m tall, the lengths are held wrong, else the time.
TimeScale JudgeTime(const std::vector<GravityEstimate>& flights, double frame_time, double stature,
                    bool scale_known, double true_gravity);

}  // namespace hazumi
