#include "tests/unit/collision/brute_force.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace hazumi::test {
namespace {

// Gaps up to this [m] are taken for 0.
constexpr double kRounding = 1e-12;

struct Minimum {
  double at, value;
};

// Golden section on a convex function, until the bracket is rounding.
template <typename F>
Minimum Minimize(double lo, double hi, const F& f) {
  constexpr double kGolden = 0.6180339887498949;
  Minimum best = f(lo) <= f(hi) ? Minimum{lo, f(lo)} : Minimum{hi, f(hi)};
  double x = hi - kGolden * (hi - lo), y = lo + kGolden * (hi - lo), fx = f(x), fy = f(y);
  for (int k = 0; k < 82; ++k) {
    if (fx < best.value) best = {x, fx};
    if (fy < best.value) best = {y, fy};
    if (fx <= fy) {
      hi = y, y = x, fy = fx, x = hi - kGolden * (hi - lo), fx = f(x);
    } else {
      lo = x, x = y, fx = fy, y = lo + kGolden * (hi - lo), fy = f(y);
    }
  }
  return best;
}

Vec3 PointAt(const Capsule& c, double t) { return c.a + t * (c.b - c.a); }

// From x (in the box's frame) to the box; the nearest point is searched, a coordinate at a time.
double SearchPointToBox(const Vec3& x, const Vec3& h) {
  Vec3 gap;
  for (int i = 0; i < 3; ++i)
    gap[i] = Minimize(-h[i], h[i], [&](double y) { return std::abs(x[i] - y); }).value;
  return gap.norm();
}

double SearchAxisDistance(const Capsule& capsule, const Box& box) {
  const Pose X_BW = box.X_WB.Inverse();
  return Minimize(0.0, 1.0,
                  [&](double t) {
                    return SearchPointToBox(X_BW.R * (PointAt(capsule, t) - box.X_WB.p),
                                            box.half_size);
                  })
      .value;
}

double SearchAxisDistance(const Capsule& capsule, const Capsule& other) {
  return Minimize(0.0, 1.0,
                  [&](double t) {
                    const Vec3 x = PointAt(capsule, t);
                    return Minimize(0.0, 1.0,
                                    [&](double u) { return (x - PointAt(other, u)).norm(); })
                        .value;
                  })
      .value;
}

// The corners of box - segment, in the box's frame.
std::vector<Vec3> DifferenceCorners(const Capsule& capsule, const Box& box) {
  std::vector<Vec3> corners;
  for (const Vec3& end : {capsule.a, capsule.b}) {
    const Vec3 end_B = box.X_WB.R.transpose() * (end - box.X_WB.p);
    for (int k = 0; k < 8; ++k) {
      const Vec3 side(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      corners.push_back(side.cwiseProduct(box.half_size) - end_B);
    }
  }
  return corners;
}

// The distance from the origin to the nearest plane with all the points on the origin's side. The
// plane is parallel to one through three of the points, if they are the corners of a body.
double HullDepth(const std::vector<Vec3>& points) {
  double depth = INFINITY;
  const auto try_normal = [&](const Vec3& n) {
    double reach = -INFINITY;
    for (const Vec3& point : points) reach = std::max(reach, n.dot(point));
    depth = std::min(depth, reach);
  };
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = i + 1; j < points.size(); ++j)
      for (size_t k = j + 1; k < points.size(); ++k) {
        const Vec3 n = (points[j] - points[i]).cross(points[k] - points[i]);
        if (n.isZero(0.0)) continue;
        try_normal(n.normalized());
        try_normal(-n.normalized());
      }
  return depth;
}

double PlaneGap(const Capsule& c, const Plane& plane) {
  const auto height = [&](double t) { return plane.normal.dot(PointAt(c, t)) - plane.offset; };
  return Minimize(0.0, 1.0, height).value - c.radius;
}

double Signed(const Capsule& c, const Plane& plane) { return PlaneGap(c, plane); }
double Signed(const Capsule& c, const Box& box) {
  const double apart = SearchAxisDistance(c, box);
  return (apart > kRounding ? apart : -HullDepth(DifferenceCorners(c, box))) - c.radius;
}
// Two crossing segments are a flat body: its depth is 0.
double Signed(const Capsule& c, const Capsule& other) {
  return SearchAxisDistance(c, other) - c.radius - other.radius;
}

double Gap(const Capsule& c, const Plane& plane) { return PlaneGap(c, plane); }
double Gap(const Capsule& c, const Box& box) {
  const auto apart = [&](double t) {
    const Vec3 x = box.X_WB.R.transpose() * (PointAt(c, t) - box.X_WB.p);
    return (x.cwiseAbs() - box.half_size).cwiseMax(0.0).norm();
  };
  return Minimize(0.0, 1.0, apart).value - c.radius;
}
double Gap(const Capsule& c, const Capsule& other) {
  const Vec3 axis = other.b - other.a;
  const double squared = std::max(axis.squaredNorm(), 1e-300);
  const auto apart = [&](double t) {
    const Vec3 x = PointAt(c, t);
    const double u = std::clamp(axis.dot(x - other.a) / squared, 0.0, 1.0);
    return (x - PointAt(other, u)).norm();
  };
  return Minimize(0.0, 1.0, apart).value - c.radius - other.radius;
}

}  // namespace

double SearchSignedDistance(const Capsule& capsule, const Obstacle& obstacle) {
  return std::visit([&](const auto& shape) { return Signed(capsule, shape); }, obstacle);
}

double SearchGap(const Capsule& capsule, const Obstacle& obstacle) {
  return std::visit([&](const auto& shape) { return Gap(capsule, shape); }, obstacle);
}

SearchedTouch SearchFirstTouch(const Capsule& capsule, const Vec3& translation,
                               const Obstacle& obstacle) {
  const auto gap = [&](double s) { return SearchGap(Moved(capsule, s * translation), obstacle); };
  const Minimum least = Minimize(0.0, 1.0, gap);
  if (least.value > kRounding) return {least.value, std::nullopt};
  if (gap(0.0) <= kRounding) return {least.value, 0.0};
  double free = 0.0, touching = least.at;
  for (int k = 0; k < 60; ++k) {
    const double s = 0.5 * (free + touching);
    (gap(s) <= kRounding ? touching : free) = s;
  }
  return {least.value, touching};
}

Capsule Moved(const Capsule& capsule, const Vec3& by) {
  return {capsule.a + by, capsule.b + by, capsule.radius};
}

}  // namespace hazumi::test
