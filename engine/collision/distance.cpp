// A capsule is a segment grown by a ball, and a ball only shifts a signed distance: between convex
// K and segment S grown by r it is SignedDistance(K, S) - r, outside and inside alike, because the
// depth is the minimum over unit n of the support function h(n) of K - S, and the ball adds r to
// every h(n). A second capsule is a box of zero width and depth, grown by its own radius.

#include "engine/collision/distance.h"

#include <algorithm>
#include <variant>

#include "engine/base/assert.h"
#include "engine/collision/segment_box.h"

namespace hazumi {
namespace {

Distance ToGrownBox(const Capsule& capsule, const GrownBox& grown) {
  HAZUMI_ASSERT(capsule.radius >= 0.0 && grown.margin >= 0.0);
  const Pose& X_WB = grown.box.X_WB;
  const Vec3 p_Ba_W = capsule.a - X_WB.p, p_ab_W = capsule.b - capsule.a;
  const SegmentBoxDistance d =
      SegmentToBox(X_WB.R.transpose() * p_Ba_W, X_WB.R.transpose() * p_ab_W, grown.box.half_size);
  const Vec3 normal_W = X_WB.R * d.normal;
  return {d.value - capsule.radius - grown.margin,
          capsule.a + d.t * p_ab_W - capsule.radius * normal_W, normal_W};
}

// A rotation whose third column is along `direction`, or the identity if that is zero.
Mat3 FrameAlong(const Vec3& direction) {
  if (direction.isZero(0.0)) return Mat3::Identity();
  Mat3 R;
  R.col(2) = direction.stableNormalized();
  R.col(0) = R.col(2).unitOrthogonal();
  R.col(1) = R.col(2).cross(R.col(0));
  return R;
}

}  // namespace

Distance SignedDistance(const Capsule& capsule, const Plane& plane) {
  const double a = plane.normal.dot(capsule.a), b = plane.normal.dot(capsule.b);
  const Vec3& lowest = a <= b ? capsule.a : capsule.b;
  return {std::min(a, b) - plane.offset - capsule.radius, lowest - capsule.radius * plane.normal,
          plane.normal};
}

GrownBox Grown(const Box& box) { return {box, 0.0}; }

GrownBox Grown(const Capsule& capsule) {
  const Vec3 p_ab = capsule.b - capsule.a;
  const Pose X_WC{FrameAlong(p_ab), 0.5 * (capsule.a + capsule.b)};
  return {{X_WC, Vec3(0.0, 0.0, 0.5 * p_ab.stableNorm())}, capsule.radius};
}

Distance SignedDistance(const Capsule& capsule, const Box& box) {
  return ToGrownBox(capsule, Grown(box));
}

Distance SignedDistance(const Capsule& capsule, const Capsule& obstacle) {
  return ToGrownBox(capsule, Grown(obstacle));
}

Distance SignedDistance(const Capsule& capsule, const Obstacle& obstacle) {
  return std::visit([&](const auto& shape) { return SignedDistance(capsule, shape); }, obstacle);
}

}  // namespace hazumi
