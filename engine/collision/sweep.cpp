// Newton's method on f(s) = SignedDistance(capsule + s translation), from the free side.
//
// f is convex, as the distance between convex bodies along a translation, and its derivative is
// normal . translation. So the tangent at s lies below f and its root is never past the first
// touch; if the tangent stays above 0 up to s = 1, so does f.
//
// The normal of two nearly parallel shapes is only good to the square root of rounding (the nearest
// point may slide far along them for no change in distance). So the slope is taken steeper than it
// is by kNormalError: the steps stay on the free side and still gain some four digits each. Gliding
// along a surface at less than about kNormalError of the path would take many steps: there the
// least gap of the rest of the path is searched (golden section), and the first touch bisected.

#include <algorithm>

#include "engine/collision/distance.h"

namespace hazumi {
namespace {

constexpr double kTouchGap = 1e-11;    // metres
constexpr double kNormalError = 1e-5;  // radians: what 1 mm from 100 m shapes may come to
constexpr int kMaxSteps = 64;
constexpr double kGolden = 0.6180339887498949;  // 0.618^80 = 2e-17

struct Path {
  const Capsule& capsule;
  const Vec3& translation;
  const Obstacle& obstacle;

  Distance At(double s) const {
    const Vec3 by = s * translation;
    return SignedDistance(Capsule{capsule.a + by, capsule.b + by, capsule.radius}, obstacle);
  }
  double GapAt(double s) const { return At(s).value; }
};

// The first touch between s = free, where the path is free, and s = touching, where it is not.
double Bisect(const Path& path, double free, double touching) {
  for (int k = 0; k < kMaxSteps && path.GapAt(touching) < -kTouchGap; ++k) {
    const double middle = 0.5 * (free + touching);
    (path.GapAt(middle) <= kTouchGap ? touching : free) = middle;
  }
  return touching;
}

// Where between s = lo and 1 the gap is least, either end included.
double LeastGap(const Path& path, double lo) {
  double hi = 1.0, x = hi - kGolden * (hi - lo), y = lo + kGolden * (hi - lo);
  double at_x = path.GapAt(x), at_y = path.GapAt(y);
  for (int k = 0; k < 80; ++k) {
    if (at_x <= at_y) {
      hi = y, y = x, at_y = at_x;
      x = hi - kGolden * (hi - lo), at_x = path.GapAt(x);
    } else {
      lo = x, x = y, at_x = at_y;
      y = lo + kGolden * (hi - lo), at_y = path.GapAt(y);
    }
  }
  return 0.5 * (lo + hi);
}

std::optional<double> SearchRest(const Path& path, double free) {
  const double s = LeastGap(path, free);
  if (path.GapAt(s) > kTouchGap) return std::nullopt;
  return Bisect(path, free, s);
}

}  // namespace

std::optional<double> FirstTouch(const Capsule& capsule, const Vec3& translation,
                                 const Obstacle& obstacle) {
  const Path path{capsule, translation, obstacle};
  const double slope_error = kNormalError * translation.norm();
  double free = 0.0, s = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Distance gap = path.At(s);
    if (gap.value <= kTouchGap) return s == 0.0 ? s : Bisect(path, free, s);
    const double slope = gap.normal.dot(translation) - slope_error;
    if (!(gap.value + slope * (1.0 - s) <= kTouchGap)) return std::nullopt;
    free = s;
    s = std::min(s - gap.value / slope, 1.0);
  }
  return SearchRest(path, free);
}

}  // namespace hazumi
