#include "ui/panels/timeline/flight_text.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/text/catalogue.h"
#include "ui/panels/text/filled.h"

namespace hazumi::ui {

std::string FlightText(const Flight& flight, double frame_time) {
  const Range gravity = flight.gravity.Interval();
  return Filled("%.2f s, %.3g m/s² (%.3g – %.3g)", flight.duration_frames() * frame_time,
                flight.gravity.gravity, gravity.low, gravity.high);
}

std::optional<int> RateToSet(const TimeScale& time) {
  constexpr double kSame = 0.01;
  if (time.verdict != TimeVerdict::kWrongFrameTime || !time.frame_rate) return std::nullopt;
  if (std::abs(*time.frame_rate * time.frame_time - 1.0) < kSame) return std::nullopt;
  return time.frame_rate;
}

std::string AlarmText(const TimeScale& time) {
  const std::string gravity =
      Filled(Tr("Gravity comes out as %.3g m/s² (%.3g – %.3g), not %.3g: "), time.gravity,
             time.gravity_range.low, time.gravity_range.high, time.true_gravity);
  if (time.verdict == TimeVerdict::kWrongFrameTime) {
    return gravity + Filled(Tr("it should be played at %.3g frames a second, not %.3g."),
                            RateToSet(time) ? *time.frame_rate : 1.0 / time.true_frame_time,
                            1.0 / time.frame_time);
  }
  if (time.verdict == TimeVerdict::kWrongLength) {
    return gravity + Filled(Tr("the size was guessed; import it again, %.2f m tall."),
                            time.stature * time.length_factor);
  }
  return "";
}

std::string UndecidedText(const TimeScale& time) {
  if (time.verdict != TimeVerdict::kUnknown || !(time.gravity > 0.0)) return "";
  return Filled(Tr("Too short or too low to tell whether speed and size are right: gravity %.3g – "
                   "%.3g m/s²."),
                std::max(time.gravity_range.low, 0.0), time.gravity_range.high);
}

std::string RepairText(const TimeScale& time) {
  const std::optional<int> rate = RateToSet(time);
  return rate ? Filled(Tr("Play at %d frames a second"), *rate) : "";
}

}  // namespace hazumi::ui
