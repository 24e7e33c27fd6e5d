#pragma once

#include <vector>

namespace hazumi {

// A number over time by keys, between two of which it steps, or is a straight line or a cubic
// Bezier curve of time and value, as FBX and Collada have them. The points of the curve between the
// keys (t0, v0) and (t1, v1) are (t0, v0), (t0 + behind.dt, v0 + behind.dv), (t1 - before.dt, v1 -
// before.dv), (t1, v1), of the first key's `behind` and `before`.
struct ScalarKey {
  enum class Kind { kStep, kStepAtOnce, kLinear, kBezier };  // at once: to the next value
  struct Handle {
    double dt = 0.0, dv = 0.0;
  };
  double t = 0.0, v = 0.0;  // [s]
  Kind kind = Kind::kLinear;
  Handle behind, before;
};

using ScalarCurve = std::vector<ScalarKey>;  // times do not decrease

// Constant before the first key and after the last; a step that is at most `slack` [s] later has
// happened. There has to be a key.
double ValueAt(const ScalarCurve& curve, double t, double slack);
bool IsSound(const ScalarCurve& curve);

}  // namespace hazumi
