// Where two capsules touch: beside their distance, and how the point moves beside differences.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/collision/distance.h"
#include "engine/region/contact/touch_point.h"

namespace hazumi::test {
namespace {

using namespace small;  // NOLINT(google-build-using-namespace): operators

// A capsule that turns about its first end as it moves.
struct Moving {
  Vec3 a, ab, v, w;
  double radius;

  MovingCapsule At(double t) const {
    const double angle = t * w.norm();
    const Vec3 axis = w.normalized();
    const Vec3 turned = Eigen::AngleAxisd(angle, axis) * ab;
    return {V3(Vec3(a + t * v)), V3(Vec3(a + t * v + turned)), V3(v), V3(w), radius};
  }
};

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double number(double most) { return most * uniform_(random_); }
  Vec3 vector(double most) { return {number(most), number(most), number(most)}; }
  Moving capsule() {
    return {vector(0.3), vector(0.4), vector(2.0), vector(3.0), 0.05 + 0.03 * number(1.0)};
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

Capsule ShapeOf(const MovingCapsule& moving) {
  return {moving.a.eigen(), moving.b.eigen(), moving.radius};
}

// The nearest pair of features is as far as the capsules are.
TEST(TouchingCapsules, AreAsFarApartAsTheirNearestFeatures) {
  Draw draw(1);
  for (int i = 0; i < 10000; ++i) {
    const MovingCapsule one = draw.capsule().At(0.0), other = draw.capsule().At(0.0);
    double gap = HUGE_VAL;
    for (int pair = 0; pair < kCapsulePairs; ++pair) {
      const auto point = TouchPointOf(pair, one, other, false);
      if (point) gap = std::min(gap, point->gap);
    }
    EXPECT_NEAR(gap, SignedDistance(ShapeOf(one), ShapeOf(other)).value, 1e-12) << i;
    EXPECT_LE(LeastGap(one, other), gap + 1e-12) << i;
  }
}

V3 VelocityAt(const MovingCapsule& capsule, const V3& p) {
  return capsule.v + Cross(capsule.w, p - capsule.a);
}

double Off(const V3& one, const V3& other) { return (one - other).eigen().norm(); }

// p', n', gap' and the change of the bodies' velocities there, by central differences.
TEST(TouchingCapsules, ThePointGlidesAsDifferencesSay) {
  constexpr double kStep = 2e-6, kSame = 1e-6;
  Draw draw(2);
  std::array<int, kCapsulePairs> seen{};
  for (int i = 0; i < 4000; ++i) {
    const Moving one = draw.capsule(), other = draw.capsule();
    for (int pair = 0; pair < kCapsulePairs; ++pair) {
      const auto now = TouchPointOf(pair, one.At(0.0), other.At(0.0), false);
      const auto before = TouchPointOf(pair, one.At(-kStep), other.At(-kStep), false);
      const auto after = TouchPointOf(pair, one.At(kStep), other.At(kStep), false);
      if (!now || !before || !after || now->gap < 0.0) continue;
      const double d = 0.5 / kStep;
      // Where an end comes to the other's end in between there is no derivative.
      if (Off(d * (after->p - now->p), d * (now->p - before->p)) > 1e-3) continue;
      ++seen[pair];
      EXPECT_LT(Off(now->p_dot, d * (after->p - before->p)), kSame) << i << " " << pair;
      EXPECT_LT(Off(now->n_dot, d * (after->n - before->n)), kSame) << i << " " << pair;
      EXPECT_NEAR(Dot(now->n, now->v), d * (after->gap - before->gap), kSame) << i << " " << pair;
      const auto v_at = [&](double t, const TouchPoint& point) {
        return VelocityAt(one.At(t), point.p) - VelocityAt(other.At(t), point.p);
      };
      EXPECT_LT(Off(now->v, v_at(0.0, *now)), 1e-12) << i << " " << pair;
      // Beside the accelerations of what is fixed to them: w x (w x r) here.
      const auto fixed = [&](const Moving& of) {
        const MovingCapsule at = of.At(0.0);
        return Cross(at.w, Cross(at.w, now->p - at.a));
      };
      const V3 change = d * (v_at(kStep, *after) - v_at(-kStep, *before));
      EXPECT_LT(Off(now->glides, change - fixed(one) + fixed(other)), 1e-4) << i << " " << pair;
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

// Ends that meet both capsules' ends do so once; a sphere has one end.
TEST(TouchingCapsules, EndsMeetOnce) {
  const V3 still;
  const MovingCapsule rod = {V3(0, 0, 0), V3(1, 0, 0), still, still, 0.1};
  const MovingCapsule beyond = {V3(1.3, 0, 0), V3(2, 0, 0), still, still, 0.1};
  const MovingCapsule ball = {V3(0.5, 0.3, 0), V3(0.5, 0.3, 0), still, still, 0.1};
  const auto count = [](const MovingCapsule& a, const MovingCapsule& b) {
    int touching = 0;
    for (int pair = 0; pair < kCapsulePairs; ++pair) {
      const auto point = TouchPointOf(pair, a, b, false);
      touching += point && std::abs(point->gap - 0.1) < 1e-12;
    }
    return touching;
  };
  EXPECT_EQ(count(rod, beyond), 1);
  EXPECT_EQ(count(beyond, rod), 1);
  EXPECT_EQ(count(rod, ball), 1);
  EXPECT_EQ(count(ball, rod), 1);
  EXPECT_EQ(count(ball, ball), 0);  // its own centre: no direction
}

// Side by side they touch at both ends of where they do.
TEST(TouchingCapsules, ParallelOnesTouchTwice) {
  const V3 still;
  const MovingCapsule rod = {V3(0, 0, 0), V3(1, 0, 0), still, still, 0.1};
  const MovingCapsule above = {V3(0.2, 0, 0.2), V3(1.4, 0, 0.2), still, still, 0.1};
  int touching = 0;
  for (int pair = 0; pair < kCapsulePairs; ++pair) {
    const auto point = TouchPointOf(pair, rod, above, false);
    if (!point || point->gap > 1e-12) continue;
    ++touching;
    EXPECT_TRUE(std::abs(point->p.x - 0.2) < 1e-12 || std::abs(point->p.x - 1.0) < 1e-12);
    EXPECT_NEAR(point->n.z, -1.0, 1e-12);
  }
  EXPECT_EQ(touching, 2);
}

}  // namespace
}  // namespace hazumi::test
