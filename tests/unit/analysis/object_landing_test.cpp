// Where what was let go lands, against the parabola of a ball whose position and velocity are
// known.

#include "engine/analysis/object_landing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hazumi {
namespace {

constexpr double kRadius = 0.05, kGravity = 9.81, kNear = 1e-9;
constexpr int kRelease = 4;

// A ball in a scene without a figure.
Animation Scene(std::vector<SceneObject> scene) {
  Animation animation;
  animation.last_frame = 60;
  animation.gravity = kGravity;
  animation.scene = std::move(scene);
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{kRadius};
  animation.held_objects = {ball};
  return animation;
}

SceneObject Ground() { return {"ground", Plane{Vec3::UnitZ(), 0.0}, ""}; }
SceneObject BoxAt(const Vec3& center, const Vec3& half_size, const Mat3& R = Mat3::Identity()) {
  Box box;
  box.X_WB = {R, center};
  box.half_size = half_size;
  return {"box", box, ""};
}

struct Throw {
  Vec3 p, v;  // as it is let go [m, m/s]
  Vec3 At(double t) const { return p + t * v - Vec3(0, 0, 0.5 * kGravity * t * t); }
};

// Held still where it is let go, up to kRelease; then on its parabola.
Motion MotionOf(const Throw& thrown, int last = 60) {
  Motion motion;
  for (int f = 0; f <= last; ++f) {
    MotionFrame frame;
    frame.frame = f;
    ObjectPose pose;
    pose.X_WO.p = thrown.At(motion.rate.SecondsAt(std::max(f - kRelease, 0)));
    pose.holder = f < kRelease ? 0 : -1;
    frame.objects = {pose};
    motion.frames.push_back(frame);
  }
  return motion;
}

// Expects a landing so long after it is let go.
void ExpectLanding(const Animation& animation, const Throw& thrown, double seconds,
                   const char* obstacle) {
  const Motion motion = MotionOf(thrown);
  const auto landing = LandingOf(animation, motion, 0);
  ASSERT_TRUE(landing);
  EXPECT_NEAR(landing->time, motion.rate.SecondsAt(kRelease) + seconds, kNear);
  EXPECT_LE((landing->position - thrown.At(seconds)).norm(), kNear);
  EXPECT_EQ(landing->obstacle, obstacle);
}

// From a height until the centre is at `end`.
double FallTime(const Throw& thrown, double end) {
  const double vz = thrown.v.z();
  return (vz + std::sqrt(vz * vz + 2.0 * kGravity * (thrown.p.z() - end))) / kGravity;
}

TEST(ObjectLanding, OnTheGroundIsWhereTheParabolaMeetsIt) {
  for (const Throw& thrown : {Throw{{0, 0, 1.5}, {2, -1, 3}}, Throw{{0.3, 0.1, 1.0}, {0, 0, 0}},
                              Throw{{0, 0, 0.2}, {1.5, 0, -4}}, Throw{{0, 0, 3}, {0.5, 0.5, -2}}}) {
    ExpectLanding(Scene({Ground()}), thrown, FallTime(thrown, kRadius), "ground");
  }
}

TEST(ObjectLanding, OnABoxIsOnItsTop) {
  const Animation animation = Scene({Ground(), BoxAt({2, 0, 0.25}, {1, 1, 0.25})});
  const Throw thrown{{0, 0, 1.5}, {2.5, 0.2, 2}};
  ExpectLanding(animation, thrown, FallTime(thrown, 0.5 + kRadius), "box");
}

TEST(ObjectLanding, AgainstABoxIsAtItsSide) {
  const Animation animation = Scene({Ground(), BoxAt({2, 0, 2}, {0.5, 2, 2})});
  const Throw thrown{{0, 0.1, 1.5}, {4, 0.3, 1}};
  ExpectLanding(animation, thrown, (1.5 - kRadius) / 4.0, "box");
}

TEST(ObjectLanding, OnASlopeIsWhereItsDistanceIsTheRadius) {
  const double angle = std::numbers::pi / 6.0;
  const Vec3 n(std::sin(angle), 0.0, std::cos(angle));
  const Throw thrown{{0, 0, 2}, {0.5, 0, 0}};
  // n . p(t) = radius
  const double a = -0.5 * kGravity * n.z(), b = n.dot(thrown.v), c = n.dot(thrown.p) - kRadius;
  const double seconds = (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
  ExpectLanding(Scene({{"slope", Plane{n, 0.0}, ""}}), thrown, seconds, "slope");
}

// The hand stands still and the ball is gone fast: what the hand did says nothing of the flight.
TEST(ObjectLanding, WithinTheFirstFrameIsExactToo) {
  const Throw thrown{{0, 0, 0.1}, {3, 0, -4}};
  const double seconds = FallTime(thrown, kRadius);
  ASSERT_LT(seconds, 1.0 / 30.0);
  Motion motion = MotionOf(thrown);
  for (int f = 0; f < kRelease; ++f) motion.frames[f].objects[0].X_WO.p = {-1, 2, 3};
  const auto landing = LandingOf(Scene({Ground()}), motion, 0);
  ASSERT_TRUE(landing);
  EXPECT_LE((landing->position - thrown.At(seconds)).norm(), kNear);
}

TEST(ObjectLanding, IsNoneWhileItIsInTheHand) {
  // Carried along a finger's breadth over the floor, and never let go.
  Motion motion = MotionOf({{0, 0, kRadius + 1e-4}, {0, 0, 0}});
  for (MotionFrame& frame : motion.frames) {
    frame.objects[0].X_WO.p = {0.1 * frame.frame, 0, kRadius + 1e-4};
    frame.objects[0].holder = 0;
  }
  EXPECT_FALSE(LandingOf(Scene({Ground()}), motion, 0));
}

// What the hand does between the last two frames in it is no fall.
TEST(ObjectLanding, DoesNotCountTheWayOfTheHand) {
  const Throw thrown{{0, 0, kRadius + 1e-4}, {0, 0, 5}};
  Motion motion = MotionOf(thrown);
  for (int f = 0; f < kRelease; ++f) {
    motion.frames[f].objects[0].X_WO.p = {0.1 * (f - kRelease), 0, kRadius + 1e-4};
  }
  const auto landing = LandingOf(Scene({Ground()}), motion, 0);
  ASSERT_TRUE(landing);
  EXPECT_NEAR(landing->time - kRelease / 30.0, FallTime(thrown, kRadius), kNear);
}

TEST(ObjectLanding, LeavesWhatItTouchesAsItIsLetGo) {
  const Throw thrown{{0, 0, kRadius}, {1, 0, 5}};
  ExpectLanding(Scene({Ground()}), thrown, 2.0 * 5.0 / kGravity, "ground");
}

TEST(ObjectLanding, IsNoneIfItTouchesNothing) {
  const Throw thrown{{0, 0, 1.5}, {2, 0, 3}};
  EXPECT_FALSE(LandingOf(Scene({}), MotionOf(thrown), 0)) << "nothing is there";
  EXPECT_FALSE(LandingOf(Scene({Ground()}), MotionOf(thrown, kRelease + 20), 0))
      << "it ends before";
  EXPECT_FALSE(LandingOf(Scene({Ground()}), Motion(), 0)) << "it has no frames";
}

TEST(ObjectLanding, CountsTheFlightFromTheLastHandOn) {
  // Caught in the air on frame 8, thrown again on frame 12.
  const Throw first{{0, 0, 1.5}, {1, 0, 1}}, second{{0.5, 0, 1.6}, {-1, 0.5, 2}};
  Motion motion = MotionOf(first);
  for (int f = 8; f <= 60; ++f) {
    motion.frames[f].objects[0].X_WO.p = second.At(std::max(f - 12, 0) / 30.0);
    motion.frames[f].objects[0].holder = f < 12 ? 0 : -1;
  }
  const auto landing = LandingOf(Scene({Ground()}), motion, 0);
  ASSERT_TRUE(landing);
  const double seconds = FallTime(second, kRadius);
  EXPECT_NEAR(landing->time, 12.0 / 30.0 + seconds, kNear);
  EXPECT_LE((landing->position - second.At(seconds)).norm(), kNear);
}

TEST(ObjectLanding, OfABoxIsThatOfTheSphereInItsMiddle) {
  Animation animation = Scene({Ground()});
  animation.held_objects[0].shape = BoxShape{{0.2, 0.1, 0.03}};
  EXPECT_EQ(InnerRadius(animation.held_objects[0]), 0.03);
  const Throw thrown{{0, 0, 1}, {1, 0, 1}};
  ExpectLanding(animation, thrown, FallTime(thrown, 0.03), "ground");
}

}  // namespace
}  // namespace hazumi
