#pragma once

#include <optional>
#include <vector>

namespace hazumi {

// How a curve runs from a key to the next one.
enum class Interpolation {
  kHold,  // stays at the key's value
  kLinear,
  kQuadratic,  // Arai 2.5 (1): from value and rate to the next value
  kCubic,      // Arai 2.5 (1), (3): from value and rate to the next value and rate
  // Least integral of the squared acceleration or jerk through all keys of a run of such intervals
  // (spline_run.h).
  kLeastAcceleration,
  kLeastJerk,
  // Eased: from value to value along a curve of its own (interval.h), whatever the rates.
  kSine,
  kQuintic,
  kExponential,
  kBack,
  kBounce,
  kElastic,
};

constexpr bool IsOfRun(Interpolation kind) {
  return kind == Interpolation::kLeastAcceleration || kind == Interpolation::kLeastJerk;
}
constexpr bool IsEased(Interpolation kind) { return kind >= Interpolation::kSine; }

// On which end of an eased interval its curve lies.
enum class Easing { kIn, kOut, kInOut };

// A value that the animator set. Values are rad for angles and m for root positions; rates are per
// second.
struct Key {
  double frame = 0.0;  // may lie between frames
  double value = 0.0;
  std::optional<double> rate;  // not given: the interval rules of interval.h
  Interpolation interpolation = Interpolation::kCubic;
  Easing easing = Easing::kInOut;      // of an eased interpolation
  std::optional<double> rate_in = {};  // with which the curve arrives; not given: `rate`
  // How far the tangents of a cubic reach, as shares of the time to the key beside it; not given:
  // a third.
  std::optional<double> length_in = {}, length_out = {};
  bool operator==(const Key&) const = default;
};

// In order of frames, no two on one frame.
using Keys = std::vector<Key>;

}  // namespace hazumi
