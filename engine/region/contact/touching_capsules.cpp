// With s and e the nearest points of two axes along u_a and u_b, d = s - e = D n and gap = D - R_a
// - R_b; v_s, v_e their velocities as points of the bodies, s' = v_s + c_a u_a and e' = v_e + c_b
// u_b where they glide. What glides stays across its axis,
//   d' u + d (w x u) = 0
// for u and w of that axis: one equation for each c. Then n' = (d' - n (n d')) / D, the point of
// contact p = s - R_a n moves with p' = s' - R_a n', and both bodies are met there.

#include <algorithm>
#include <cmath>

#include "engine/region/contact/touch_point.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

constexpr double kPointLength = 1e-9;  // [m]
constexpr double kAlongside = 1e-3;    // sine of an angle below which ends tell more than sides

// The axis of a capsule, with a point of it, `at` from its first end [m].
struct AxisPoint {
  const MovingCapsule* capsule = nullptr;
  V3 u;  // unit; zero of a sphere
  double length = 0.0, at = 0.0;
  bool glides = false;

  V3 place() const { return capsule->a + at * u; }
  V3 velocity() const { return capsule->v + Cross(capsule->w, at * u); }
  // Its ends [m].
  double beyond() const { return std::max(-at, at - length); }
};

AxisPoint AxisOf(const MovingCapsule& capsule) {
  AxisPoint axis;
  axis.capsule = &capsule;
  const V3 ab = capsule.b - capsule.a;
  const double length = std::sqrt(Dot(ab, ab));
  if (length < kPointLength) return axis;
  axis.u = (1.0 / length) * ab;
  axis.length = length;
  return axis;
}

// Nearest to x, on the whole line.
void Glide(const V3& x, AxisPoint* axis) {
  axis->at = Dot(x - axis->capsule->a, axis->u);
  axis->glides = true;
}

// Nearest to each other, on the whole lines. False: they are parallel, or there is one only.
bool GlideBoth(AxisPoint* a, AxisPoint* b) {
  if (a->length == 0.0 || b->length == 0.0) return false;
  const double k = Dot(a->u, b->u), square = 1.0 - k * k;
  if (square < kAlongside * kAlongside) return false;
  const V3 between = a->capsule->a - b->capsule->a;
  const double of_a = Dot(between, a->u), of_b = Dot(between, b->u);
  a->at = (k * of_b - of_a) / square;
  b->at = (of_b - k * of_a) / square;
  a->glides = b->glides = true;
  return true;
}

// With which s and e glide along their axes [m/s].
struct Glides {
  double a = 0.0, b = 0.0;
};
Glides GlidesOf(const AxisPoint& a, const AxisPoint& b, const V3& d) {
  const V3 v = a.velocity() - b.velocity();
  const double of_a = Dot(v, a.u) + Dot(d, Cross(a.capsule->w, a.u));
  const double of_b = Dot(v, b.u) + Dot(d, Cross(b.capsule->w, b.u));
  if (!a.glides) return {0.0, b.glides ? of_b : 0.0};
  if (!b.glides) return {-of_a, 0.0};
  const double k = Dot(a.u, b.u), square = 1.0 - k * k;
  return {(k * of_b - of_a) / square, (of_b - k * of_a) / square};
}

std::optional<TouchPoint> Meet(const AxisPoint& a, const AxisPoint& b, double beyond) {
  const V3 d = a.place() - b.place();
  const double distance = std::sqrt(Dot(d, d));
  if (distance < kPointLength) return std::nullopt;
  const MovingCapsule &own = *a.capsule, &other = *b.capsule;
  const Glides glides = GlidesOf(a, b, d);
  TouchPoint point;
  point.beyond = beyond;
  point.gap = distance - own.radius - other.radius;
  point.n = (1.0 / distance) * d;
  const V3 s_dot = a.velocity() + glides.a * a.u;
  const V3 d_dot = s_dot - b.velocity() - glides.b * b.u;
  point.n_dot = (1.0 / distance) * (d_dot - Dot(point.n, d_dot) * point.n);
  point.p = a.place() - own.radius * point.n;
  point.p_dot = s_dot - own.radius * point.n_dot;
  const V3 v_own = own.v + Cross(own.w, point.p - own.a);
  const V3 v_other = other.v + Cross(other.w, point.p - other.a);
  point.v = v_own - v_other;
  point.glides = Cross(own.w, point.p_dot - v_own) - Cross(other.w, point.p_dot - v_other);
  return point;
}

}  // namespace

std::optional<TouchPoint> TouchPointOf(int pair, const MovingCapsule& capsule,
                                       const MovingCapsule& other, bool is_touching) {
  AxisPoint a = AxisOf(capsule), b = AxisOf(other);
  if (pair == 4) {
    if (!GlideBoth(&a, &b)) return std::nullopt;
    const double beyond = std::max(a.beyond(), b.beyond());
    if (!is_touching && beyond >= 0.0) return std::nullopt;
    return Meet(a, b, beyond);
  }
  AxisPoint &end = pair < 2 ? a : b, &side = pair < 2 ? b : a;
  if (pair % 2 == 1 && end.length == 0.0) return std::nullopt;  // a sphere has one end
  end.at = pair % 2 == 1 ? end.length : 0.0;
  if (side.length > 0.0) Glide(end.place(), &side);
  if (pair < 2) {
    const double at = std::clamp(side.at, 0.0, side.length);
    side.glides = side.glides && at == side.at;
    side.at = at;
  } else if (side.length == 0.0 || (!is_touching && side.beyond() >= 0.0)) {
    return std::nullopt;
  }
  return Meet(a, b, pair < 2 ? TouchPoint().beyond : side.beyond());
}

double LeastGap(const MovingCapsule& capsule, const MovingCapsule& other) {
  const V3 half = 0.5 * (capsule.b - capsule.a), half_other = 0.5 * (other.b - other.a);
  const V3 d = 0.5 * (capsule.a + capsule.b) - 0.5 * (other.a + other.b);
  return std::sqrt(Dot(d, d)) - std::sqrt(Dot(half, half)) -
         std::sqrt(Dot(half_other, half_other)) - capsule.radius - other.radius;
}

}  // namespace hazumi
