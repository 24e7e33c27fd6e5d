#pragma once

#include "engine/timeline/keyframe.h"

namespace hazumi {

// A way from 0 to 1 in the time u from 0 to 1, with its first and second derivatives by u.
struct Eased {
  double value = 0.0, slope = 0.0, curvature = 0.0;
};

// For an eased `kind`. Exactly 0 and 1 at the ends, and their limits from inside there.
Eased Ease(Interpolation kind, Easing easing, double u);

// Up to which u > `from` the way is smooth: where it bounces, where its two halves meet, or 1.
double SmoothUntil(Interpolation kind, Easing easing, double from);

}  // namespace hazumi
