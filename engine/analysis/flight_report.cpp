#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/analysis/flights.h"

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

// "(0.24 to 0.26)"
std::string RangeText(const Range& range) {
  if (!std::isfinite(range.high)) return Format("(%.3g or more)", range.low);
  return Format("(%.3g to %.3g)", range.low, range.high);
}

// "1/4 speed (0.24 to 0.26)", "3 times its speed (2.9 to 3.1)", "0.63 of its speed (0.6 to 0.65)".
std::string SpeedText(const TimeScale& time) {
  const double speed = time.speed;
  const std::string range = " " + RangeText(SpeedRange(time));
  if (speed < 1.0 && WholeNear(1.0 / speed) > 1)
    return Format("1/%d speed", WholeNear(1.0 / speed)) + range;
  if (speed > 1.0 && WholeNear(speed) > 1)
    return Format("%d times its speed", WholeNear(speed)) + range;
  return Format("%.2f of its speed", speed) + range;
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

// "1.53 times too great (1.47 to 1.59)"
std::string LengthsText(const TimeScale& time) {
  const Range range = LengthFactorRange(time);
  const bool is_great = time.length_factor < 1.0;
  const double factor = is_great ? 1.0 / time.length_factor : time.length_factor;
  return Format("%.2f times too %s ", factor, is_great ? "great" : "small") +
         RangeText(is_great ? Range{1.0 / range.high, 1.0 / range.low} : range);
}

std::string WrongLength(const TimeScale& time) {
  return GravityText(time) + ": lengths are probably " + LengthsText(time) +
         Format(", or frames %.3g s apart", time.true_frame_time);
}

std::string WrongFrameTime(const TimeScale& time) {
  return "this clip plays at " + SpeedText(time) + ": its frame time is " + TrueFrameTime(time) +
         ", not " + FrameTimeText(time.frame_time) +
         (time.is_human ? ", or lengths are " + LengthsText(time) : "");
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

// "gravity 9.8 (9.39 to 10.2) m/s^2, CoM within 1.5 mm (rms) of its parabola"
std::string GravityOf(const Flight& flight) {
  return Format("gravity %.3g ", flight.gravity.gravity) + RangeText(flight.gravity.Interval()) +
         Format(" m/s^2, CoM within %.1f mm (rms) of its parabola", 1000.0 * flight.parabola.rms);
}

// The farther end of the gravity's range, as a share of the true one.
double FarthestFromTrue(const TimeScale& time) {
  const Range& range = time.gravity_range;
  return std::max(1.0 - range.low / time.true_gravity, range.high / time.true_gravity - 1.0);
}

std::string Undecided(const TimeScale& time) {
  return Format("no verdict: flights this short or low leave gravity between %.3g and %.3g m/s^2",
                std::max(time.gravity_range.low, 0.0), time.gravity_range.high);
}

void Describe(const Flight& flight, double frame_time, std::vector<std::string>* lines) {
  lines->push_back("flight     " + PlaceText(flight));
  lines->push_back(Format("           %.3f s, CoM rises %.3f m, %.2f m/s over the ground",
                          flight.duration_frames() * frame_time, flight.rise,
                          flight.horizontal_speed));
  lines->push_back("           " + GravityOf(flight));
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
      return time.gravity > 0.0 ? Undecided(time) : "";
    case TimeVerdict::kTrue:
      return Format("gravity is right within %.0f %%: the clip plays at its natural speed",
                    std::ceil(100.0 * FarthestFromTrue(time)));
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
  const Range range = LengthFactorRange(time);
  if (range.Contains(1.0)) {
    return Format(
               "guessed from the figure's height, %.2f m, and gravity does not contradict: times ",
               time.stature) +
           RangeText(range);
  }
  return Format("guessed from the figure's height, %.2f m; fitted to gravity: lengths times %.3g ",
                time.stature, time.length_factor) +
         RangeText(range) + Format(", height %.2f m", time.stature * time.length_factor);
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
