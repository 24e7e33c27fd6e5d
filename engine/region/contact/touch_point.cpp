// With s a point of the capsule's axis, e the nearest one of the obstacle, s - e = D n and
// gap = D - R; u the axis' direction, v_s the velocity of s as a point of the body, s' = v_s + c u
// where s glides along the axis with c:
//   face       n' = 0,  s' = v_s
//   end near an edge or a corner
//              n' = (what of v_s leads across the edge or corner, less n (n v_s)) / D
//   side near a corner
//              c = -v_s u - D n (w x u),   n' = (s' - n (n s')) / D
//   side near an edge along k, m = n x k
//              n' = m b,  b = -n (w x u) / (m u),   c = (D b - m v_s) / (m u)
// The point of contact p = s - R n moves with p' = s' - R n'.

#include "engine/region/contact/touch_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

constexpr double kTiny = 1e-9;      // [m]
constexpr double kParallel = 1e-3;  // sine of an angle below which ends tell more than sides
constexpr double kSlack = 1e-9;     // of a normal's parts

// A nearest point of the axis, as it glides.
struct Near {
  double distance;
  V3 s, n;
  V3 v_s, s_dot, n_dot;
  double beyond = -std::numeric_limits<double>::infinity();
};

double& Part(V3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }
double Part(const V3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

V3 Unit(int i) { return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0}; }

TouchPoint Finish(const Near& near, const MovingCapsule& capsule) {
  TouchPoint point;
  const V3 r = -capsule.radius * near.n;
  point.gap = near.distance - capsule.radius;
  point.p = near.s + r;
  point.n = near.n;
  point.v = near.v_s + Cross(capsule.w, r);
  point.p_dot = near.s_dot - capsule.radius * near.n_dot;
  point.n_dot = near.n_dot;
  point.glides = Cross(capsule.w, point.p_dot - point.v);
  point.beyond = near.beyond;
  return point;
}

Near EndNearPlane(const V3& s, const V3& v, const ContactObstacle& plane) {
  const V3 n(plane.normal);
  return {Dot(n, s) - plane.offset, s, n, v, v, V3()};
}

// In the box's axes.
Near EndNearBox(const V3& s, const V3& v, const Vec3& half) {
  V3 d, across;
  int deepest = 0;
  double depth = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double x = Part(s, i), beyond = std::abs(x) - half[i];
    if (beyond > 0.0) {
      Part(d, i) = std::copysign(beyond, x);
      Part(across, i) = Part(v, i);
    }
    if (-beyond < depth) {
      depth = -beyond;
      deepest = i;
    }
  }
  const double distance = std::sqrt(Dot(d, d));
  if (distance < kTiny) {
    return {-depth, s, std::copysign(1.0, Part(s, deepest)) * Unit(deepest), v, v, V3()};
  }
  const V3 n = (1.0 / distance) * d;
  return {distance, s, n, v, v, (1.0 / distance) * (across - Dot(n, across) * n)};
}

// The axis of a capsule, in a box's frame.
struct Axis {
  V3 a, u, v, w;
  double length;
};

std::optional<Near> SideNearEdge(int edge, const Axis& axis, const Vec3& half, bool is_touching) {
  const int k = edge / 4, i = (k + 1) % 3, j = (k + 2) % 3;
  const double side_i = edge % 2 ? 1.0 : -1.0, side_j = edge % 4 > 1 ? 1.0 : -1.0;
  const V3 along = Unit(k);
  V3 a = axis.a, u = axis.u;
  Part(a, i) -= side_i * half[i];
  Part(a, j) -= side_j * half[j];
  const double height = Part(a, k), climb = Part(u, k);
  Part(a, k) = Part(u, k) = 0.0;
  const double square = Dot(u, u);
  if (square < kParallel * kParallel) return std::nullopt;
  const double at = -Dot(a, u) / square;
  const V3 d = a + at * u;
  const double distance = std::sqrt(Dot(d, d));
  if (distance < kTiny) return std::nullopt;
  const V3 n = (1.0 / distance) * d;
  const double past = std::max({-at, at - axis.length, std::abs(height + at * climb) - half[k]});
  const double aside = std::max(-side_i * Part(d, i), -side_j * Part(d, j));
  if (!is_touching && (past >= 0.0 || aside > kSlack * distance)) return std::nullopt;
  const V3 m = Cross(n, along), v_s = axis.v + Cross(axis.w, at * axis.u);
  const double across = Dot(m, axis.u);
  const double turn = -Dot(n, Cross(axis.w, axis.u)) / across;
  const double glide = (distance * turn - Dot(m, v_s)) / across;
  return Near{distance, axis.a + at * axis.u, n, v_s, v_s + glide * axis.u,
              turn * m, std::max(past, aside)};
}

std::optional<Near> SideNearCorner(int corner, const Axis& axis, const Vec3& half,
                                   bool is_touching) {
  V3 x;
  for (int i = 0; i < 3; ++i) Part(x, i) = corner >> i & 1 ? half[i] : -half[i];
  const double at = Dot(x - axis.a, axis.u);
  const V3 s = axis.a + at * axis.u, d = s - x;
  const double distance = std::sqrt(Dot(d, d));
  if (distance < kTiny) return std::nullopt;
  const V3 n = (1.0 / distance) * d;
  const double past = std::max(-at, at - axis.length);
  double aside = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) aside = std::max(aside, -std::copysign(1.0, Part(x, i)) * Part(d, i));
  if (!is_touching && (past >= 0.0 || aside > kSlack * distance)) return std::nullopt;
  const V3 v_s = axis.v + Cross(axis.w, at * axis.u);
  const double glide = -Dot(v_s, axis.u) - distance * Dot(n, Cross(axis.w, axis.u));
  const V3 s_dot = v_s + glide * axis.u;
  return Near{distance,
              s,
              n,
              v_s,
              s_dot,
              (1.0 / distance) * (s_dot - Dot(n, s_dot) * n),
              std::max(past, aside)};
}

}  // namespace

std::optional<TouchPoint> TouchPointOf(int pair, const MovingCapsule& capsule,
                                       const ContactObstacle& obstacle, bool is_touching) {
  const V3 ab = capsule.b - capsule.a;
  const double length = std::sqrt(Dot(ab, ab));
  if (pair >= 1 && length < kTiny) return std::nullopt;  // a sphere has one end
  const V3 v_b = capsule.v + Cross(capsule.w, ab);
  if (!obstacle.is_box) {
    return Finish(pair == 0 ? EndNearPlane(capsule.a, capsule.v, obstacle)
                            : EndNearPlane(capsule.b, v_b, obstacle),
                  capsule);
  }
  const M3 R = ToSmall(obstacle.R);
  const V3 p(obstacle.p);
  std::optional<Near> near;
  if (pair < 2) {
    near = EndNearBox(TransposeTimes(R, (pair == 0 ? capsule.a : capsule.b) - p),
                      TransposeTimes(R, pair == 0 ? capsule.v : v_b), obstacle.half_size);
  } else {
    const Axis axis = {TransposeTimes(R, capsule.a - p), (1.0 / length) * TransposeTimes(R, ab),
                       TransposeTimes(R, capsule.v), TransposeTimes(R, capsule.w), length};
    near = pair < 14 ? SideNearEdge(pair - 2, axis, obstacle.half_size, is_touching)
                     : SideNearCorner(pair - 14, axis, obstacle.half_size, is_touching);
  }
  if (!near) return std::nullopt;
  return Finish({near->distance, p + R * near->s, R * near->n, R * near->v_s, R * near->s_dot,
                 R * near->n_dot, near->beyond},
                capsule);
}

double LeastGap(const MovingCapsule& capsule, const ContactObstacle& obstacle) {
  if (!obstacle.is_box) {
    const V3 n(obstacle.normal);
    return std::min(Dot(n, capsule.a), Dot(n, capsule.b)) - obstacle.offset - capsule.radius;
  }
  const V3 middle = 0.5 * (capsule.a + capsule.b), half = 0.5 * (capsule.b - capsule.a);
  const V3 x = TransposeTimes(ToSmall(obstacle.R), middle - V3(obstacle.p));
  V3 d;
  for (int i = 0; i < 3; ++i) {
    Part(d, i) = std::max(0.0, std::abs(Part(x, i)) - obstacle.half_size[i]);
  }
  return std::sqrt(Dot(d, d)) - std::sqrt(Dot(half, half)) - capsule.radius;
}

}  // namespace hazumi
