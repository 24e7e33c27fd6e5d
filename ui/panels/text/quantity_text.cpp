#include "ui/panels/text/quantity_text.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/problems/problems.h"
#include "engine/base/filled.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

// The speed left after t seconds is factor^(30 t).
std::string FrictionInWords(double factor) {
  if (factor <= 0.0) return Tr("Frozen: no speed is left.");
  if (factor >= 1.0) return Tr("No friction: all speed stays.");
  const double half_s = std::log(0.5) / (30.0 * std::log(factor));
  return Filled(Tr("Speed halves in %.2f s; after 1 s %.2g %% is left."), half_s,
                100.0 * std::pow(factor, 30.0));
}

std::string FlightText(const Flight& flight, double frame_time) {
  const Range gravity = flight.gravity.Interval();
  return Filled("%.2f s, %.3g m/s² (%.3g – %.3g)", flight.duration_frames() * frame_time,
                flight.gravity.gravity, gravity.low, gravity.high);
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
