// Take-off and landing in continuous time, with known times.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/momentum.h"
#include "tests/support/stick_figures.h"

namespace hazumi::test {
namespace {

constexpr double kTime = 1e-9;  // [s]

Animation Exact(Figure figure) {
  Animation animation = Still(std::move(figure));
  animation.solver.method = Method::kExact;
  return animation;
}

// A stiff pogo thrown from `height` with velocity (vx, vz).
Animation Thrown(double height, double vx, double vz) {
  Animation animation = Exact(Pogo());
  animation.root_keys[kRootX] = {{0, 0.0, vx, kCubic}};
  animation.root_keys[kRootZ] = {{0, height, vz, kCubic}};
  AddGravity(&animation, 0, 30);
  return animation;
}

// Roots of f between a and b, where it changes sign.
template <typename Function>
double Bisect(double a, double b, Function&& f) {
  const bool rises = f(b) > 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (a + b);
    ((f(middle) > 0.0) == rises ? b : a) = middle;
  }
  return b;
}

TEST(ContinuousGround, LandsAndTurnsWhenTheParabolaSays) {
  for (const double vz : {2.0, 0.0, -3.0}) {
    Animation animation = Thrown(1.05, 0.3, vz);
    AddFloor(&animation);
    const Motion motion = BakeOrFail(animation);
    const auto landings = EventsOf(motion, EventKind::kLanding);
    ASSERT_EQ(landings.size(), 1u) << vz;
    EXPECT_NEAR(landings[0].time, (vz + std::sqrt(vz * vz + kG)) / kG, kTime) << vz;
    EXPECT_EQ(landings[0].joint, "foot");
    const auto apexes = EventsOf(motion, EventKind::kApex);
    ASSERT_EQ(apexes.size(), vz > 0.0 ? 1u : 0u);
    for (const MotionEvent& apex : apexes) EXPECT_NEAR(apex.time, vz / kG, kTime);
    EXPECT_NEAR(motion.frames[30].X_WR.p.z(), 0.55, 1e-8);
    EXPECT_EQ(motion.events.back().kind, EventKind::kLanding);
  }
}

TEST(ContinuousGround, LandsOnASlopeWhenTheParabolaMeetsIt) {
  const double tilt = 0.4;
  Animation animation = Thrown(1.4, 1.0, 1.5);
  const Vec3 normal(std::sin(tilt), 0.0, std::cos(tilt));
  animation.scene.push_back({"slope", Plane{normal, 0.0}, ""});
  const Motion motion = BakeOrFail(animation);
  const double expected = Bisect(0.2, 2.0, [&](double t) {
    const Vec3 foot(1.0 * t, 0.0, 0.9 + 1.5 * t - 0.5 * kG * t * t);
    return 0.05 - normal.dot(foot);
  });
  const auto landings = EventsOf(motion, EventKind::kLanding);
  ASSERT_GE(landings.size(), 1u);
  EXPECT_NEAR(landings[0].time, expected, kTime);
}

// 30 m/s is 1 m a frame.
TEST(ContinuousGround, APlateOfFiveMillimetresStopsAFallAtThirtyMetresASecond) {
  for (const double height : {4.0, 4.3, 4.77, 5.001}) {
    Animation animation = Thrown(height, 0.0, -30.0);
    animation.scene.push_back({"plate", Box{Pose(), Vec3(0.5, 0.5, 0.0025)}, ""});
    const Motion motion = BakeOrFail(animation);
    const auto landings = EventsOf(motion, EventKind::kLanding);
    ASSERT_EQ(landings.size(), 1u) << height;
    const double fall = height - 0.55 - 0.0025;
    EXPECT_NEAR(landings[0].time, (-30.0 + std::sqrt(900.0 + 2.0 * kG * fall)) / kG, kTime);
    EXPECT_NEAR(motion.frames[30].X_WR.p.z(), 0.5525, 1e-8) << height;
  }
}

// The foot passes the edge of a plate by this much.
TEST(ContinuousGround, AMissIsAMiss) {
  for (const double gap : {0.001, -0.001}) {
    Animation animation = Thrown(3.0, 0.0, -20.0);
    animation.root_keys[kRootX] = {{0, 0.5 + 0.1 + gap, 0.0, kCubic}};
    animation.scene.push_back({"plate", Box{Pose(), Vec3(0.5, 0.5, 0.0025)}, ""});
    const auto landings = EventsOf(BakeOrFail(animation), EventKind::kLanding);
    EXPECT_EQ(landings.empty(), gap > 0.0) << gap;
  }
}

// TwoLinks stands on its foot while its knee stretches by a cubic:
//   angle(s) = 1.6 - 1.4 s^2 (3 - 2 s), s = 5 t;  CoM above the foot 0.2 + 1.6/6 cos(angle).
struct Stretch {
  static constexpr double kStart = 1.6, kWay = 1.4, kSpeed = 5.0;
  double t;
  double s() const { return kSpeed * t; }
  double angle() const { return kStart - kWay * s() * s() * (3.0 - 2.0 * s()); }
  double rate() const { return -kWay * 6.0 * s() * (1.0 - s()) * kSpeed; }
  double acceleration() const { return -kWay * 6.0 * (1.0 - 2.0 * s()) * kSpeed * kSpeed; }
  double height() const { return 0.2 + 1.6 / 6.0 * std::cos(angle()); }
  double velocity() const { return -1.6 / 6.0 * std::sin(angle()) * rate(); }
  double upward() const {
    return -1.6 / 6.0 * (std::cos(angle()) * rate() * rate() + std::sin(angle()) * acceleration());
  }
};

Animation Jump() {
  Animation animation = Exact(TwoLinks());
  KeysOf(&animation, "knee") = {{0, 1.6, 0.0, kCubic}, {6, 0.2, 0.0, kCubic}};
  animation.root_keys[kRootZ] = {{0, 0.45 + 0.4 * std::cos(1.6), {}, kCubic}};
  AddFloor(&animation);
  AddGravity(&animation, 0, 30).pin = GroupOf(animation, "foot");
  return animation;
}

TEST(ContinuousGround, TakesOffWhenTheGroundWouldHaveToPull) {
  const Animation animation = Jump();
  const Motion motion = BakeOrFail(animation);
  const double expected = Bisect(0.08, 0.15, [](double t) { return Stretch{t}.upward() + kG; });
  ASSERT_LT(Stretch{expected + 1e-6}.upward(), -kG);
  const auto take_offs = EventsOf(motion, EventKind::kTakeOff);
  ASSERT_EQ(take_offs.size(), 1u);
  EXPECT_NEAR(take_offs[0].time, expected, 1e-8);
  EXPECT_EQ(take_offs[0].joint, "foot");
  // From there on the CoM is on the parabola.
  const Stretch at{expected};
  const double apex = expected + at.velocity() / kG;
  const auto apexes = EventsOf(motion, EventKind::kApex);
  ASSERT_EQ(apexes.size(), 1u);
  EXPECT_NEAR(apexes[0].time, apex, 1e-8);
  const double top = 0.05 + at.height() + 0.5 * at.velocity() * at.velocity() / kG;
  const int f = static_cast<int>(std::ceil(30.0 * apex));
  const double t = f / 30.0 - apex;
  EXPECT_NEAR(motion.frames[f].com.z(), top - 0.5 * kG * t * t, 1e-9);
  // And it comes down on the foot with the knee at 0.2.
  const auto landings = EventsOf(motion, EventKind::kLanding);
  ASSERT_EQ(landings.size(), 1u);
  const double low = 0.05 + 0.2 + 1.6 / 6.0 * std::cos(0.2);
  EXPECT_NEAR(landings[0].time, apex + std::sqrt(2.0 * (top - low) / kG), 1e-8);
}

TEST(ContinuousGround, StandsWhileItsLegStretchesSlowly) {
  Animation animation = Jump();
  KeysOf(&animation, "knee")[1].frame = 25;
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(EventsOf(motion, EventKind::kTakeOff).empty());
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_NEAR(OriginOf(animation, frame, "foot").z(), 0.05, 1e-12) << frame.frame;
  }
}

// A human that turns about the vertical falls on its feet and then down, arms and root free.
Animation Fall() {
  Animation animation = Exact(Human());
  animation.solver.tolerance = 1e-9;
  DynamicsRegion& region = AddRegion(&animation, "arms", 0, 30, {"r_shoulder", "l_shoulder"});
  region.root = true;
  region.method = Method::kExact;
  KeysOf(&animation, "r_shoulder_x") = {{0, -0.6, 3.0, kCubic}};
  KeysOf(&animation, "l_elbow_y") = {{0, -1.0, 2.0, kCubic}};
  KeysOf(&animation, "r_knee") = {{0, 0.6, {}, kCubic}};
  animation.root_keys[kRootZ] = {{0, 1.2, 0.0, kCubic}};
  animation.root_keys[kRootAngleZ] = {{0, 0.0, 2.0, kCubic}};
  animation.root_keys[kRootAngleY] = {{0, 0.05, 0.3, kCubic}};
  AddFloor(&animation);
  AddGravity(&animation, 0, 30);
  return animation;
}

// The ground's force acts at the pin, gravity along the vertical.
TEST(ContinuousGround, ALandingKeepsTheMomentumAboutTheVerticalThroughThePinAndTakesEnergy) {
  const Animation animation = Fall();
  const Motion motion = BakeOrFail(animation);
  const auto landings = EventsOf(motion, EventKind::kLanding);
  ASSERT_GE(landings.size(), 1u);
  const int f = landings[0].frame;
  ASSERT_TRUE(motion.frames[f].pinned.has_value());
  const Vec3 pin = OriginOf(animation, motion.frames[f], landings[0].joint.c_str());
  const auto about_pin = [&](const MotionFrame& frame) {
    const Momentum m = MomentumOf(*animation.figure, frame.after);
    return (m.L + m.mass * (m.com - pin).cross(m.com_v)).z();
  };
  const auto energy = [&](const MotionFrame& frame) {
    const Momentum m = MomentumOf(*animation.figure, frame.after);
    return m.kinetic + m.potential(kG);
  };
  const double before = about_pin(motion.frames[0]);
  for (int i = 0; i <= f; ++i) {
    EXPECT_NEAR(about_pin(motion.frames[i]), before, 1e-7 * std::abs(before)) << i;
  }
  EXPECT_NEAR(energy(motion.frames[f - 1]), energy(motion.frames[0]), 1e-6);
  EXPECT_LT(energy(motion.frames[f]), energy(motion.frames[0]) - 1.0);
}

// Pinned at a joint while another point of the figure touches, it may leave and touch at once.
TEST(ContinuousGround, TakeOffsAndLandingsDoNotFollowEachOtherWithoutEnd) {
  const Motion motion = BakeOrFail(Fall());
  EXPECT_EQ(motion.frames.size(), 31u);
  EXPECT_LT(EventsOf(motion, EventKind::kLanding).size(), 30u * 6u);
}

}  // namespace
}  // namespace hazumi::test
