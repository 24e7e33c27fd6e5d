#include "engine/exchange/scene/scalar_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hazumi {
namespace {

double Bezier(double a, double b, double c, double d, double s) {
  const double r = 1.0 - s;
  return r * r * r * a + 3.0 * r * r * s * b + 3.0 * r * s * s * c + s * s * s * d;
}

// Where a curve of times has a time: bisection, which handles that reach beyond their segment do
// not confuse.
double ParameterAt(double t0, double t1, double t2, double t3, double t) {
  constexpr int kHalvings = 52;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (Bezier(t0, t1, t2, t3, middle) <= t ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double Between(const ScalarKey& a, const ScalarKey& b, double t) {
  const double s = (t - a.t) / (b.t - a.t);
  if (a.kind == ScalarKey::Kind::kLinear) return a.v + s * (b.v - a.v);
  // Handles of a third of the segment make time linear.
  const double third = (b.t - a.t) / 3.0;
  const bool is_even = std::abs(a.behind.dt - third) <= 1e-9 * third &&
                       std::abs(a.before.dt - third) <= 1e-9 * third;
  const double part = is_even ? s : ParameterAt(a.t, a.t + a.behind.dt, b.t - a.before.dt, b.t, t);
  return Bezier(a.v, a.v + a.behind.dv, b.v - a.before.dv, b.v, part);
}

}  // namespace

double ValueAt(const ScalarCurve& curve, double t, double slack) {
  assert(!curve.empty());
  const auto is_before = [](double time, const ScalarKey& key) { return time < key.t; };
  const auto after = std::upper_bound(curve.begin(), curve.end(), t, is_before);
  if (after == curve.begin()) return curve.front().v;
  const ScalarKey& key = *(after - 1);
  if (after == curve.end()) return key.v;
  switch (key.kind) {
    case ScalarKey::Kind::kStep:
      return t + slack < after->t ? key.v : after->v;
    case ScalarKey::Kind::kStepAtOnce:
      return t - slack > key.t ? after->v : key.v;
    default:
      return Between(key, *after, t);
  }
}

bool IsSound(const ScalarCurve& curve) {
  constexpr double kLatest = 1e9;  // [s]
  const auto is_finite = [](const ScalarKey& key) {
    return std::abs(key.t) < kLatest && std::isfinite(key.v) && std::isfinite(key.behind.dt) &&
           std::isfinite(key.behind.dv) && std::isfinite(key.before.dt) &&
           std::isfinite(key.before.dv);
  };
  return std::all_of(curve.begin(), curve.end(), is_finite) &&
         std::is_sorted(curve.begin(), curve.end(),
                        [](const ScalarKey& a, const ScalarKey& b) { return a.t < b.t; });
}

}  // namespace hazumi
