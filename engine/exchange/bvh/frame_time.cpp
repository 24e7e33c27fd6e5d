#include <cmath>
#include <optional>

#include "engine/exchange/bvh/bvh_motion.h"

namespace hazumi {

namespace {

constexpr double kTolerance = 1e-4;  // relative

bool IsNear(double seconds, double fps) { return std::abs(seconds * fps - 1.0) <= kTolerance; }

std::optional<double> NearRate(double seconds) {
  const double whole = std::round(1.0 / seconds);
  if (whole >= 1.0 && whole <= 1000.0 && IsNear(seconds, whole)) return 1.0 / whole;
  for (const int thousands : {24, 30, 60, 120}) {
    if (IsNear(seconds, thousands / 1.001)) return 1.001 / thousands;
  }
  return std::nullopt;
}

// The rate meant by a time of three digits after the point or more, but too few to be near it.
std::optional<double> RoundedRate(double seconds, std::string_view written) {
  const size_t point = written.find('.');
  if (point == written.npos) return std::nullopt;
  const std::string_view digits = written.substr(point + 1);
  if (digits.size() < 3 || digits.find_first_not_of("0123456789") != digits.npos)
    return std::nullopt;
  const double unit = std::pow(10.0, -static_cast<double>(digits.size()));
  for (const int fps : {24, 30, 60, 120, 240, 48, 72, 90, 144}) {
    const double cut = 1.0 / fps - seconds;  // what a cut took off
    if (cut >= -0.501 * unit && cut < unit) return 1.0 / fps;
  }
  return std::nullopt;
}

}  // namespace

SnappedFrameTime SnapFrameTime(double seconds, std::string_view written) {
  if (const auto near = NearRate(seconds)) return {*near, false};
  if (const auto meant = RoundedRate(seconds, written)) return {*meant, true};
  return {seconds, false};
}

}  // namespace hazumi
