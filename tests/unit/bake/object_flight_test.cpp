// Balls that are let go and touch planes and boxes, beside closed forms.

#include "engine/bake/pose/object_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/collision/distance.h"

namespace hazumi {
namespace {

constexpr double kG = 9.81, kRadius = 0.11, kMass = 0.6;
constexpr double kInertia = 0.4 * kMass * kRadius * kRadius;

HeldObject Ball(double restitution, double friction = SceneObject::kFriction) {
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{kRadius};
  ball.mass = kMass;
  ball.touches_scene = true;
  ball.friction = friction;
  ball.restitution = restitution;
  return ball;
}

SceneObject Slope(double angle, double friction = SceneObject::kFriction) {
  SceneObject slope;
  slope.name = "slope";
  slope.shape = Plane{Vec3(std::sin(angle), 0.0, std::cos(angle)), 0.0};
  slope.friction = friction;
  return slope;
}
SceneObject Floor(double friction = SceneObject::kFriction) { return Slope(0.0, friction); }

SceneObject Block(const Vec3& centre, const Vec3& half_size, const Mat3& R = Mat3::Identity()) {
  SceneObject block;
  block.name = "block";
  block.shape = Box{{R, centre}, half_size};
  return block;
}

// At a height above the floor, turned somehow.
BodyMotion At(double height, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero()) {
  const Mat3 R = Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  return {{R, Vec3(0.0, 0.0, kRadius + height)}, v, w};
}

double ClearanceOf(const std::vector<SceneObject>& scene, const BodyMotion& at) {
  double least = 1e9;
  for (const SceneObject& object : scene) {
    const Capsule ball = {at.X_WB.p, at.X_WB.p, kRadius};
    least = std::min(least, SignedDistance(ball, object.shape).value);
  }
  return least;
}

double EnergyOf(const BodyMotion& at) {
  return 0.5 * kMass * at.v.squaredNorm() + 0.5 * kInertia * at.w.squaredNorm() +
         kMass * kG * at.X_WB.p.z();
}

TEST(ObjectFlight, BouncesByItsRestitution) {
  const double h = 1.3, t_0 = 2.0;
  for (const double e : {0.3, 0.5, 0.75, 0.9, 1.0}) {
    ObjectFlight flight(Ball(e), {Floor()}, kG, t_0, At(h));
    double t = t_0 + std::sqrt(2.0 * h / kG), v = kG * (t - t_0);
    for (int bounce = 1; bounce <= 12; ++bounce) {
      v *= e;
      if (v < 0.05) break;
      const double up = v / kG;
      EXPECT_NEAR(flight.At(t).X_WB.p.z(), kRadius, 1e-6) << e << " " << bounce;
      EXPECT_NEAR(flight.At(t + 1e-3 * up).v.z(), 0.999 * v, 1e-6) << e << " " << bounce;
      const double top = flight.At(t + up).X_WB.p.z() - kRadius;
      EXPECT_NEAR(top, std::pow(e, 2 * bounce) * h, 1e-6) << e << " " << bounce;
      t += 2.0 * up;
    }
    if (e == 1.0) continue;
    const BodyMotion last = flight.At(t_0 + 30.0);
    EXPECT_NEAR(last.X_WB.p.z(), kRadius, 1e-6) << e;
    EXPECT_LT(last.v.norm(), 1e-9) << e;
    EXPECT_LT((last.X_WB.R - At(h).X_WB.R).norm(), 1e-9) << e;
    EXPECT_FALSE(flight.stuck_from());
  }
}

TEST(ObjectFlight, WithoutRestitutionItLiesWhereItFell) {
  const double h = 0.9, t_hit = std::sqrt(2.0 * h / kG);
  ObjectFlight flight(Ball(0.0), {Floor()}, kG, 0.0, At(h));
  for (int i = 1; i <= 300; ++i) {
    const double t = i / 30.0;
    const double z = kRadius + (t < t_hit ? h - 0.5 * kG * t * t : 0.0);
    EXPECT_NEAR(flight.At(t).X_WB.p.z(), z, 1e-8) << t;
  }
}

// With u the velocity of the point that touches, an impulse along the ground stops it, or is mu
// times that along the normal: what is less.
TEST(ObjectFlight, LeavesWithTheSpinOfASlidingOrARollingImpact) {
  const double h = 0.8, v_hit = std::sqrt(2.0 * kG * h);
  const Vec3 w(3.0, -20.0, 5.0), v(4.0, 1.0, 0.0);
  for (const double e : {0.0, 0.4, 0.8}) {
    for (const double mu : {0.0, 0.1, 0.25, 1.0}) {
      ObjectFlight flight(Ball(e, mu), {Floor(mu)}, kG, 0.0, At(h, v, w));
      const Vec3 arm(0.0, 0.0, -kRadius), u = v + w.cross(arm);
      const double stops = u.norm() / (1.0 / kMass + kRadius * kRadius / kInertia);
      const double most = mu * kMass * (1.0 + e) * v_hit;
      const Vec3 impulse = -std::min(stops, most) * u.normalized();
      const Vec3 v_then = v + impulse / kMass, w_then = w + arm.cross(impulse) / kInertia;
      if (e == 0.0 && stops > most) continue;  // it goes on sliding
      const double later = e > 0.0 ? 0.5 * e * v_hit / kG : 0.1;
      const double rises = e > 0.0 ? e * v_hit - kG * later : 0.0;
      const BodyMotion then = flight.At(v_hit / kG + later);
      EXPECT_LT((then.v - v_then - rises * Vec3::UnitZ()).norm(), 1e-7) << e << " " << mu;
      EXPECT_LT((then.w - w_then).norm(), 1e-6) << e << " " << mu;
    }
  }
}

TEST(ObjectFlight, SlidesAndThenRolls) {
  const double v_0 = 3.0, mu = 0.3;
  const double t_roll = v_0 / (mu * kG * (1.0 + kMass * kRadius * kRadius / kInertia));
  const double way = v_0 * t_roll - 0.5 * mu * kG * t_roll * t_roll, rolls = 5.0 / 7.0 * v_0;
  EXPECT_NEAR(v_0 - mu * kG * t_roll, rolls, 1e-12);
  ObjectFlight flight(Ball(0.5, mu), {Floor(mu)}, kG, 0.0, At(0.0, v_0 * Vec3::UnitX()));
  for (int i = 1; i <= 150; ++i) {
    const double t = i / 30.0;
    const BodyMotion at = flight.At(t);
    const bool is_rolling = t > t_roll;
    const double x = is_rolling ? way + rolls * (t - t_roll) : v_0 * t - 0.5 * mu * kG * t * t;
    EXPECT_NEAR(at.X_WB.p.x(), x, 1e-6) << t;
    EXPECT_NEAR(at.X_WB.p.z(), kRadius, 1e-7) << t;
    if (is_rolling) {
      EXPECT_NEAR(at.v.x(), rolls, 1e-6) << t;
      EXPECT_NEAR(at.w.y(), rolls / kRadius, 1e-5) << t;
    } else {
      EXPECT_NEAR(at.v.x(), v_0 - mu * kG * t, 1e-7) << t;
    }
  }
}

TEST(ObjectFlight, RollsDownAnIncline) {
  const double angle = 0.35;
  const Vec3 up(std::sin(angle), 0.0, std::cos(angle)), down(up.z(), 0.0, -up.x());
  BodyMotion start;
  start.X_WB.p = kRadius * up;
  ObjectFlight flight(Ball(0.6), {Slope(angle)}, kG, 1.0, start);
  const double a = kG * std::sin(angle) / (1.0 + kInertia / (kMass * kRadius * kRadius));
  for (int i = 1; i <= 90; ++i) {
    const double t = i / 30.0;
    const Vec3 expected = start.X_WB.p + 0.5 * a * t * t * down;
    EXPECT_LT((flight.At(1.0 + t).X_WB.p - expected).norm(), 1e-6) << t;
  }
}

TEST(ObjectFlight, LiesOnABox) {
  const double top = 0.7;
  const std::vector<SceneObject> scene = {Floor(),
                                          Block(Vec3(0.0, 0.0, 0.35), Vec3(0.3, 0.3, 0.35))};
  ObjectFlight flight(Ball(0.4), scene, kG, 0.0, At(1.2));
  const BodyMotion still = flight.At(5.0), later = flight.At(20.0);
  EXPECT_NEAR(still.X_WB.p.z(), top + kRadius, 1e-6);
  EXPECT_LT((still.X_WB.p - later.X_WB.p).norm(), 1e-9);
  EXPECT_LT(later.v.norm() + later.w.norm(), 1e-9);
}

// From a box onto the floor, over its edge.
TEST(ObjectFlight, RollsOffABox) {
  const std::vector<SceneObject> scene = {Floor(),
                                          Block(Vec3(0.0, 0.0, 0.35), Vec3(0.3, 0.3, 0.35))};
  ObjectFlight flight(Ball(0.0), scene, kG, 0.0,
                      At(0.7, 0.4 * Vec3::UnitX(), (0.4 / kRadius) * Vec3::UnitY()));
  EXPECT_NEAR(flight.At(5.0).X_WB.p.z(), kRadius, 1e-6);
  EXPECT_GT(flight.At(5.0).X_WB.p.x(), 1.0);
}

TEST(ObjectFlight, StaysOutOfThingsAndGainsNothing) {
  std::mt19937 random(7);
  const auto number = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto any = [&](double size) {
    return Vec3(number(-size, size), number(-size, size), number(-size, size));
  };
  for (int i = 0; i < 60; ++i) {
    std::vector<SceneObject> scene = {Floor(number(0.0, 1.0)), Slope(number(-0.6, 0.6))};
    for (int k = 0; k < 3; ++k) {
      const Mat3 R = Eigen::AngleAxisd(number(0.0, 3.0), any(1.0).normalized()).toRotationMatrix();
      scene.push_back(Block(any(1.5), Vec3(0.5, 0.3, 0.1), R));
    }
    BodyMotion start = At(2.5, any(6.0), any(30.0));
    start.X_WB.p.head<2>() = any(1.0).head<2>();
    if (ClearanceOf(scene, start) < 0.0) continue;
    ObjectFlight flight(Ball(number(0.0, 1.0), number(0.0, 1.2)), scene, kG, 0.0, start);
    double energy = EnergyOf(start);
    const double scale =
        kMass * kG + 0.5 * kMass * start.v.squaredNorm() + 0.5 * kInertia * start.w.squaredNorm();
    for (int f = 1; f <= 4 * 240; ++f) {
      const BodyMotion at = flight.At(f / 240.0);
      ASSERT_GT(ClearanceOf(scene, at), -1e-4) << i << " " << f;
      ASSERT_LT(EnergyOf(at), energy + 1e-6 * scale) << i << " " << f;
      energy = EnergyOf(at);
    }
    EXPECT_FALSE(flight.stuck_from()) << i;
  }
}

TEST(ObjectFlight, WhatBeginsInsideSomethingGetsNoDeeperAndMovesOn) {
  for (const double depth : {1e-4, 1e-3, 5e-3, 0.05}) {
    for (const double speed : {0.0, 1.0}) {
      ObjectFlight flight(Ball(0.5), {Floor()}, kG, 0.0, At(-depth, speed * Vec3::UnitX()));
      double deepest = 0.0;
      for (int f = 1; f <= 300; ++f) {
        deepest = std::max(deepest, kRadius - flight.At(f / 60.0).X_WB.p.z());
      }
      EXPECT_LT(deepest, depth + 1e-4) << depth << " " << speed;
      EXPECT_FALSE(flight.stuck_from()) << depth << " " << speed;
      EXPECT_GE(flight.At(5.0).X_WB.p.x(), 2.5 * speed - 1e-9) << depth;
    }
  }
}

TEST(ObjectFlight, IsTheSameInWhateverOrderItIsAsked) {
  const BodyMotion start = At(1.0, Vec3(2.0, 0.5, 1.0), Vec3(3.0, -4.0, 9.0));
  const std::vector<SceneObject> scene = {Floor()};
  ObjectFlight forwards(Ball(0.7), scene, kG, 0.5, start), other(Ball(0.7), scene, kG, 0.5, start);
  EXPECT_EQ(forwards.At(0.5), start);
  std::vector<BodyMotion> all;
  for (int i = 0; i <= 90; ++i) all.push_back(forwards.At(0.5 + i / 30.0));
  for (int i = 90; i >= 0; i -= 7) EXPECT_EQ(other.At(0.5 + i / 30.0), all[i]) << i;
  for (int i = 0; i <= 90; i += 5) EXPECT_EQ(other.At(0.5 + i / 30.0), all[i]) << i;
}

}  // namespace
}  // namespace hazumi
