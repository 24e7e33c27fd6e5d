// The surface of two spheres (a, ra), (b, rb) and the cone tangent to both.
// With e = (b - a) / |b - a|, a tangent plane of both spheres has a normal n with
//   n . e = (ra - rb) / |b - a| = cos(split),
// so the sphere at a shows where the angle between n and e is in [split, pi], the sphere at b where
// it is in [0, split], and the cone joins the two rings of angle `split` along straight lines.
// The normal is therefore continuous over the whole solid. |ra - rb| >= |b - a|: only one sphere.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "render/mesh/solid_mesh.h"
#include "render/mesh/surface_grid.h"

namespace hazumi::render {
namespace {

// A capsule with its axis made explicit.
struct CapsuleFrame {
  Vec3 a, b;
  double radius_a, radius_b;
  Mat3 R_WC;     // the third column points from a to b
  double split;  // [rad]
};

Mat3 FrameAlong(const Vec3& axis) {
  const Vec3 helper = std::abs(axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  Mat3 R;
  R.col(0) = helper.cross(axis).normalized();
  R.col(1) = axis.cross(R.col(0));
  R.col(2) = axis;
  return R;
}

CapsuleFrame MakeSphere(const Vec3& center, double radius) {
  return {center, center, radius, radius, Mat3::Identity(), std::numbers::pi / 2.0};
}

CapsuleFrame MakeFrame(const TaperedCapsule& c) {
  const double length = (c.b - c.a).norm();
  if (c.radius_a >= length + c.radius_b) return MakeSphere(c.a, c.radius_a);
  if (c.radius_b >= length + c.radius_a) return MakeSphere(c.b, c.radius_b);
  const double split = std::acos((c.radius_a - c.radius_b) / length);
  return {c.a, c.b, c.radius_a, c.radius_b, FrameAlong((c.b - c.a) / length), split};
}

// The rings of one end, at angles from `from` to `to` against the axis.
struct Cap {
  Vec3 center;
  double radius, from, to;
};

void AppendCap(const Cap& cap, int steps, const std::vector<Turn>& turns, const Mat3& R_WC,
               const LinearColor& color, SolidMesh& mesh) {
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::lerp(cap.from, cap.to, double(i) / steps);
    const double across = std::sin(angle), along = std::cos(angle);
    for (const Turn& turn : turns) {
      const Vec3 n = R_WC * Vec3(across * turn.cosine, across * turn.sine, along);
      AppendVertex(cap.center + cap.radius * n, n, color, mesh);
    }
  }
}

}  // namespace

void AppendTaperedCapsule(const TaperedCapsule& capsule, int columns, SolidMesh& mesh) {
  const CapsuleFrame f = MakeFrame(capsule);
  const LinearColor color = ToLinear(capsule.color);
  const std::vector<Turn> turns = ColumnTurns(columns);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const int steps = columns / 4;
  AppendCap({f.a, f.radius_a, std::numbers::pi, f.split}, steps, turns, f.R_WC, color, mesh);
  AppendCap({f.b, f.radius_b, f.split, 0.0}, steps, turns, f.R_WC, color, mesh);
  JoinRings(first, 2 * (steps + 1), columns, mesh);
}

}  // namespace hazumi::render
