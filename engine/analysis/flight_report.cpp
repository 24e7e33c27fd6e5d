#include "engine/analysis/flight_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hazumi {

namespace {

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 256> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

// The whole number that a ratio is within 5 % of, else 0.
int WholeNear(double ratio) {
  const double whole = std::round(ratio);
  return std::abs(ratio / whole - 1.0) < 0.05 ? static_cast<int>(whole) : 0;
}

// "1/4 speed", "3 times its speed", "0.63 of its speed".
std::string SpeedText(double speed) {
  if (speed < 1.0 && WholeNear(1.0 / speed) > 1)
    return Format("1/%d speed", WholeNear(1.0 / speed));
  if (speed > 1.0 && WholeNear(speed) > 1) return Format("%d times its speed", WholeNear(speed));
  return Format("%.2f of its speed", speed);
}

// "1/120 s", "0.0135 s".
std::string FrameTimeText(double seconds) {
  const double rate = std::round(1.0 / seconds);
  if (std::abs(seconds * rate - 1.0) < 0.002) return Format("1/%.0f s", rate);
  return Format("%.3g s", seconds);
}

std::string TrueFrameTime(const TimeScale& time) {
  if (time.frame_rate) return Format("probably 1/%d s", *time.frame_rate);
  return Format("about %.3g s", time.true_frame_time);
}

std::string GravityText(const TimeScale& time) {
  return Format("gravity comes out as %.3g m/s^2 instead of %.3g", time.gravity, time.true_gravity);
}

// "1.53 times too great"
std::string LengthsText(const TimeScale& time) {
  return Format("%.2f times too %s", std::max(time.length_factor, 1.0 / time.length_factor),
                time.length_factor < 1.0 ? "great" : "small");
}

std::string WrongLength(const TimeScale& time) {
  return GravityText(time) + ": lengths are probably " + LengthsText(time) +
         Format(" (or frames %.3g s apart)", time.true_frame_time);
}

std::string WrongFrameTime(const TimeScale& time) {
  return "this clip plays at " + SpeedText(time.speed) + ": its frame time is " +
         TrueFrameTime(time) + ", not " + FrameTimeText(time.frame_time) +
         (time.is_human ? " (or lengths are " + LengthsText(time) + ")" : "");
}

std::string PlaceText(const Flight& flight) {
  return Format("F%.1f%s to F%.1f%s, apex F%.1f", flight.take_off,
                flight.begins_before_clip ? " (clip begins)" : "", flight.landing,
                flight.ends_after_clip ? " (clip ends)" : "", flight.apex);
}

std::string DriftText(const AngularMomentumDrift& drift) {
  return Format("angular momentum %.2f kg m^2/s on average, changes by %.2f", drift.mean.norm(),
                drift.change.norm());
}

// "gravity 9.80 +- 0.08 m/s^2, CoM within 1.5 mm (rms) of its parabola"
std::string GravityOf(const Parabola& parabola) {
  constexpr double kShown = 0.001;  // of gravity: smaller errors are not
  const bool uncertain = parabola.gravity_error > kShown * parabola.gravity;
  return Format("gravity %.3g", parabola.gravity) +
         (uncertain ? Format(" +- %.2g", parabola.gravity_error) : "") +
         Format(" m/s^2, CoM within %.1f mm (rms) of its parabola", 1000.0 * parabola.rms);
}

void Describe(const Flight& flight, double frame_time, std::vector<std::string>* lines) {
  lines->push_back("flight     " + PlaceText(flight));
  lines->push_back(Format("           %.3f s, CoM rises %.3f m, %.2f m/s over the ground",
                          flight.duration_frames() * frame_time, flight.rise,
                          flight.horizontal_speed));
  lines->push_back("           " + GravityOf(flight.parabola));
  if (!flight.angular_momentum) return;
  lines->push_back("           " + DriftText(*flight.angular_momentum));
}

std::string SkateText(const FootSkate& skate) {
  return Format("skate      %s: slides %.3f m in %.2f s on the ground, %d %s faster than 0.1 m/s",
                skate.foot.c_str(), skate.distance, skate.time_low, skate.frames,
                skate.frames == 1 ? "frame" : "frames");
}

}  // namespace

std::string TimeSentence(const TimeScale& time) {
  switch (time.verdict) {
    case TimeVerdict::kUnknown:
      return "";
    case TimeVerdict::kTrue:
      return Format("gravity is right within %.0f %%: the clip plays at its natural speed",
                    std::ceil(100.0 * std::abs(time.gravity / time.true_gravity - 1.0)));
    case TimeVerdict::kWrongFrameTime:
      return WrongFrameTime(time);
    case TimeVerdict::kWrongLength:
      return WrongLength(time);
  }
  return "";
}

std::string LengthSentence(const TimeScale& time) {
  if (time.scale_known || time.verdict == TimeVerdict::kUnknown) return "";
  if (time.verdict == TimeVerdict::kWrongFrameTime) {
    return Format("guessed from the figure's height, %.2f m", time.stature);
  }
  return Format(
      "guessed from the figure's height, %.2f m; fitted to gravity: lengths times %.3g, "
      "height %.2f m",
      time.stature, time.length_factor, time.stature * time.length_factor);
}

std::vector<std::string> FlightReport(const FlightAnalysis& analysis) {
  std::vector<std::string> lines;
  for (const Flight& flight : analysis.flights) {
    Describe(flight, analysis.time.frame_time, &lines);
  }
  if (analysis.flights.empty())
    lines.push_back("flight     none: a foot is on the ground, or the CoM is on no parabola");
  const std::string time = TimeSentence(analysis.time), length = LengthSentence(analysis.time);
  if (!time.empty()) lines.push_back("time       " + time);
  if (!length.empty()) lines.push_back("lengths    " + length);
  for (const FootSkate& skate : analysis.skates) lines.push_back(SkateText(skate));
  return lines;
}

}  // namespace hazumi
