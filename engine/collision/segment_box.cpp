// Apart: with e_i(t) = how far x_i = p_i + t d_i is beyond the slab |x_i| <= h_i (0 inside it), the
// squared distance sum e_i(t)^2 is convex, and quadratic between the t where x crosses a slab's
// plane. There the slabs beyond which x lies, and on which side sigma_i, are fixed, so the minimum
// of the piece is  t* = -sum d_i (p_i - sigma_i h_i) / sum d_i^2  over those i, clamped to it.
// Every piece is tried and the nearest kept. Searching the derivative for its change of sign would
// be shorter, but for a segment nearly parallel to an axis rounding finds the wrong piece, which
// costs up to sqrt(rounding), 1e-6 m; an extra candidate costs nothing.
//
// Overlapping: the least separating translation is the distance from the origin to the boundary of
// box - segment, a zonotope with edges along the axes u_i and d, so its faces have the normals
// +-u_i and +-u_i x d. Along unit n the separation is  min(n.p, n.(p + d)) - sum h_i |n_i|,  and
// any n bounds the depth from above, so a badly rounded normal can do no harm.

#include "engine/collision/segment_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hazumi {
namespace {

// Nearer than this [m] counts as overlapping: the direction e / |e| is then mostly rounding.
constexpr double kTouchingLength = 1e-12;
// A u_i x d shorter than this [m] changes no depth by more than this.
constexpr double kParallel = 1e-13;

struct Segment {
  const Vec3& p;
  const Vec3& d;
  Vec3 At(double t) const { return p + t * d; }
};

// 0, 1 and between them the t where the segment crosses a slab's plane, in order.
struct Cuts {
  std::array<double, 8> t{0.0, 1.0};
  int count = 2;
};

Cuts CutBySlabs(const Segment& segment, const Vec3& h) {
  Cuts cuts;
  for (int i = 0; i < 3; ++i) {
    if (segment.d[i] == 0.0) continue;
    for (const double plane : {-h[i], h[i]}) {
      const double t = (plane - segment.p[i]) / segment.d[i];
      if (t > 0.0 && t < 1.0) cuts.t[cuts.count++] = t;
    }
  }
  std::sort(cuts.t.begin(), cuts.t.begin() + cuts.count);
  return cuts;
}

// The t* of the piece between two neighbouring cuts.
double PieceMinimum(const Segment& segment, const Vec3& h, double from, double to) {
  const Vec3 middle = segment.At(0.5 * (from + to));
  double slope = 0.0, curvature = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(middle[i]) <= h[i]) continue;
    slope += segment.d[i] * (segment.p[i] - std::copysign(h[i], middle[i]));
    curvature += segment.d[i] * segment.d[i];
  }
  return curvature > 0.0 ? std::clamp(-slope / curvature, from, to) : from;
}

// From the box's nearest point to x.
Vec3 Beyond(const Vec3& x, const Vec3& h) { return x - x.cwiseMax(-h).cwiseMin(h); }

double NearestParameter(const Segment& segment, const Vec3& h) {
  const Cuts cuts = CutBySlabs(segment, h);
  double best_t = 0.0, best = Beyond(segment.p, h).squaredNorm();
  for (int k = 0; k + 1 < cuts.count; ++k) {
    const double t = PieceMinimum(segment, h, cuts.t[k], cuts.t[k + 1]);
    const double squared = Beyond(segment.At(t), h).squaredNorm();
    if (squared < best) best_t = t, best = squared;
  }
  return best_t;
}

// Keeps in `best` whichever of itself, n and -n separates most (overlaps least). n is unit.
void TryNormal(const Segment& segment, const Vec3& h, const Vec3& n, SegmentBoxDistance* best) {
  const double from = n.dot(segment.p), to = n.dot(segment.At(1.0)), reach = h.dot(n.cwiseAbs());
  const double along = std::min(from, to) - reach, against = -std::max(from, to) - reach;
  if (along > best->value) best->value = along, best->normal = n;
  if (against > best->value) best->value = against, best->normal = -n;
}

SegmentBoxDistance Overlap(const Segment& segment, const Vec3& h) {
  SegmentBoxDistance best{-std::numeric_limits<double>::infinity(), 0.0, Vec3::UnitX()};
  for (int i = 0; i < 3; ++i) {
    const Vec3 u = Vec3::Unit(i), across = u.cross(segment.d);
    TryNormal(segment, h, u, &best);
    const double length = across.norm();
    if (length > kParallel) TryNormal(segment, h, across / length, &best);
  }
  // Moved out along the normal, the segment touches the box where it was deepest.
  const Vec3 p_out = segment.p - best.value * best.normal;
  best.t = NearestParameter({p_out, segment.d}, h);
  return best;
}

}  // namespace

SegmentBoxDistance SegmentToBox(const Vec3& p, const Vec3& d, const Vec3& half_size) {
  const Segment segment{p, d};
  const double t = d.isZero(0.0) ? 0.0 : NearestParameter(segment, half_size);
  const Vec3 gap = Beyond(segment.At(t), half_size);
  const double length = gap.norm();
  if (length <= kTouchingLength) return Overlap(segment, half_size);
  return {length, t, gap / length};
}

}  // namespace hazumi
