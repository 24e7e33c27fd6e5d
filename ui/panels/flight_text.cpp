#include "ui/panels/flight_text.h"

#include <cmath>
#include <cstdio>

#include "ui/panels/catalogue.h"

namespace hazumi::ui {

namespace {

template <typename... Values>
std::string Formatted(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::string FlightText(const Flight& flight, double frame_time) {
  return Formatted("%.2f s, %.3g m/s²", flight.duration_frames() * frame_time,
                   flight.parabola.gravity);
}

std::string AlarmText(const TimeScale& time) {
  const std::string gravity =
      Formatted(Tr("Gravity comes out as %.3g m/s², not %.3g: "), time.gravity, time.true_gravity);
  if (time.verdict == TimeVerdict::kWrongFrameTime) {
    return gravity + Formatted(Tr("it should be played at %.3g frames a second, not %.3g."),
                               time.frame_rate ? *time.frame_rate : 1.0 / time.true_frame_time,
                               1.0 / time.frame_time);
  }
  if (time.verdict == TimeVerdict::kWrongLength) {
    return gravity + Formatted(Tr("the size was guessed; import it again, %.2f m tall."),
                               time.stature * time.length_factor);
  }
  return "";
}

std::string RepairText(const TimeScale& time) {
  if (AlarmText(time).empty() || !time.frame_rate) return "";
  return Formatted(Tr("Play at %d frames a second"), *time.frame_rate);
}

}  // namespace hazumi::ui
