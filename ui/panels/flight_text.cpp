#include "ui/panels/flight_text.h"

#include <cmath>

#include "ui/panels/catalogue.h"
#include "ui/panels/filled.h"

namespace hazumi::ui {

std::string FlightText(const Flight& flight, double frame_time) {
  return Filled("%.2f s, %.3g m/s²", flight.duration_frames() * frame_time,
                flight.parabola.gravity);
}

std::optional<int> RateToSet(const TimeScale& time) {
  constexpr double kSame = 0.01;
  if (time.verdict != TimeVerdict::kWrongFrameTime || !time.frame_rate) return std::nullopt;
  if (std::abs(*time.frame_rate * time.frame_time - 1.0) < kSame) return std::nullopt;
  return time.frame_rate;
}

std::string AlarmText(const TimeScale& time) {
  const std::string gravity =
      Filled(Tr("Gravity comes out as %.3g m/s², not %.3g: "), time.gravity, time.true_gravity);
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

std::string RepairText(const TimeScale& time) {
  const std::optional<int> rate = RateToSet(time);
  return rate ? Filled(Tr("Play at %d frames a second"), *rate) : "";
}

}  // namespace hazumi::ui
