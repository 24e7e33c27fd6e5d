// Holds (inverse kinematics) in a bake, and what follows them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

// The human sinks and sways over both feet until frame 5, then over the left one.
Animation Sway(bool orientation) {
  Animation animation = Still(Human());
  animation.root_keys[kRootX] = {{0, 0.0, {}, kCubic}, {5, 0.08, {}, kCubic}};
  animation.root_keys[kRootZ] = {{0, 0.90, {}, kCubic}, {5, 0.84, {}, kCubic}};
  animation.root_keys[kRootAngleZ] = {
      {0, 0.0, {}, kCubic}, {5, 0.2, {}, kCubic}, {15, 0.0, {}, kCubic}};
  for (const char* side : {"r", "l"}) {
    const auto keys = [&](const char* joint) -> Keys& {
      return KeysOf(&animation, (std::string(side) + joint).c_str());
    };
    keys("_hip_y") = {{0, -0.4, {}, kCubic}, {5, -0.5, {}, kCubic}, {15, -0.3, {}, kCubic}};
    keys("_knee") = {{0, 0.8, {}, kCubic}, {5, 1.0, {}, kCubic}, {15, 0.6, {}, kCubic}};
    keys("_ankle_y") = {{0, -0.4, {}, kCubic}, {5, -0.5, {}, kCubic}, {15, -0.3, {}, kCubic}};
  }
  AddHold(&animation, 0, 5, "r_toe", orientation);
  AddHold(&animation, 0, 5, "l_toe", orientation);
  AddPin(&animation, 5, 30, "l_toe");
  KeyTheRest(&animation);
  return animation;
}

TEST(Hold, KeepsItsJointsInPlace) {
  for (const bool orientation : {false, true}) {
    const Animation animation = Sway(orientation);
    const Motion motion = BakeOrFail(animation);
    for (const char* toe : {"r_toe", "l_toe"}) {
      const Vec3 held = OriginOf(animation, motion.frames[0], toe);
      for (int f = 0; f <= 5; ++f) {
        const MotionFrame& frame = motion.frames[f];
        EXPECT_LE((OriginOf(animation, frame, toe) - held).norm(), 1e-9) << toe << f;
        EXPECT_LE(VelocityOf(animation, frame, frame.before, toe).norm(), 1e-9) << toe << f;
      }
    }
    EXPECT_GT((motion.frames[5].X_WR.p - motion.frames[0].X_WR.p).norm(), 0.09);
  }
}

TEST(Hold, LeavesAngleAndRateToTheCurveAndThePin) {
  const Animation animation = Sway(true);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& frame = motion.frames[5];
  EXPECT_LE((frame.before.q - frame.after.q).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((frame.before.X_WR.p - frame.after.X_WR.p).norm(), 1e-9);
  EXPECT_LE((frame.before.qd - frame.after.qd).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LE((frame.before.root_v - frame.after.root_v).norm(), 1e-9);
  EXPECT_LE((frame.before.root_w - frame.after.root_w).norm(), 1e-9);
  EXPECT_GT(frame.before.root_v.norm(), 0.1);
  for (int f = 5; f <= 30; ++f) {
    EXPECT_LE((OriginOf(animation, motion.frames[f], "l_toe") -
               OriginOf(animation, motion.frames[0], "l_toe"))
                  .norm(),
              1e-9)
        << f;
  }
  EXPECT_TRUE(motion.warnings.empty()) << motion.warnings[0].message;
}

TEST(Hold, OutOfReachIsAnErrorWithFrameAndDistance) {
  Animation animation = Sway(false);
  animation.root_keys[kRootZ] = {{0, 0.9, {}, kCubic}, {5, 1.1, {}, kCubic}};
  animation.root_keys[kRootX] = animation.root_keys[kRootAngleZ] = {};
  const Error error = BakeError(animation);
  EXPECT_EQ(error.code, ErrorCode::kSemantics);
  EXPECT_EQ(error.place, "holds[0]");
  Animation continuous = animation;
  continuous.solver.method = Method::kExact;
  EXPECT_EQ(BakeError(continuous).ToString(), error.ToString());
  // At frame 5 the hip is 1.05 m high. The leg is 0.4 + 0.4 + sqrt(0.15^2 + 0.07^2) m long.
  animation.holds.clear();
  const Vec3 toe = OriginOf(animation, BakeOrFail(animation).frames[0], "r_toe");
  const double reach = 0.8 + std::hypot(0.15, 0.07);
  const double distance = (Vec3(0.0, -0.1, 1.05) - toe).norm() - reach;
  char expected[64];
  std::snprintf(expected, sizeof expected, "is out of reach at frame 5: %.4f m", distance);
  EXPECT_NE(error.message.find(expected), std::string::npos) << error.message << expected;
}

// The human stands on straight legs, whose ankles are held while the pelvis rises by so much [m].
Animation Stretch(double rise, Method method) {
  Animation animation = Still(Human());
  animation.solver.method = method;
  animation.root_keys[kRootZ] = {{0, 0.9, {}, kCubic}, {5, 0.9 + rise, {}, kCubic}};
  AddHold(&animation, 0, 5, "r_ankle", false);
  AddHold(&animation, 0, 5, "l_ankle", false);
  KeyTheRest(&animation);
  return animation;
}

TEST(Hold, OutOfReachByATenthOfAMillimetreIsHeldThatMuchBesideWithAWarning) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    for (const double rise : {1e-12, 1e-9, 3e-8, 1e-6, 5e-5, 9e-5}) {
      const Animation animation = Stretch(rise, method);
      const Motion motion = BakeOrFail(animation);
      for (const char* ankle : {"r_ankle", "l_ankle"}) {
        const Vec3 held = OriginOf(animation, motion.frames[0], ankle);
        for (int f = 0; f <= 5; ++f) {
          EXPECT_LE((OriginOf(animation, motion.frames[f], ankle) - held).norm(), rise + 1.1e-5)
              << rise << ankle << f;
          EXPECT_TRUE(motion.frames[f].after.qd.allFinite()) << rise << ankle << f;
        }
      }
      if (rise < 1e-9) continue;
      ASSERT_EQ(motion.warnings.size(), 2u) << rise;
      EXPECT_EQ(motion.warnings[0].place, "holds[0]");
      EXPECT_NE(motion.warnings[0].message.find("by 0.1 mm at most"), std::string::npos);
    }
    const Error error = BakeError(Stretch(1.2e-4, method));
    EXPECT_NE(error.message.find("out of reach"), std::string::npos) << error.message;
  }
}

// The human bows by its keys while both hands hold on, elbows bent to begin with.
Animation HoldOn(double bow) {
  Animation animation = Still(Human());
  animation.root_keys[kRootZ] = {{0, 0.9, {}, kCubic}};
  KeysOf(&animation, "waist_y") = {{0, 0.0, {}, kCubic}, {10, bow, {}, kCubic}};
  for (const char* side : {"r", "l"}) {
    KeysOf(&animation, (std::string(side) + "_shoulder_y").c_str()) = {{0, -0.6, {}, kCubic}};
    KeysOf(&animation, (std::string(side) + "_elbow").c_str()) = {{0, -1.2, {}, kCubic}};
  }
  AddHold(&animation, 0, 10, "r_wrist", false);
  AddHold(&animation, 0, 10, "l_wrist", false);
  KeyTheRest(&animation);
  return animation;
}

TEST(Hold, MovesTheLimbAlone) {
  const Animation animation = HoldOn(0.3);
  const Motion motion = BakeOrFail(animation);
  Animation free = animation;
  free.holds.clear();
  const Motion keyed = BakeOrFail(free);
  const Figure& figure = *animation.figure;
  for (int f = 0; f <= 10; ++f) {
    for (const char* wrist : {"r_wrist", "l_wrist"}) {
      const Vec3 held = OriginOf(animation, motion.frames[0], wrist);
      EXPECT_LE((OriginOf(animation, motion.frames[f], wrist) - held).norm(), 1e-9) << wrist << f;
    }
    for (const char* hinge : {"waist_y", "waist_x", "chest_y", "chest_x", "neck_y"}) {
      const int j = figure.FindJoint(hinge)->value();
      EXPECT_EQ(motion.frames[f].q[j], keyed.frames[f].q[j]) << hinge << f;
    }
  }
}

TEST(Hold, OutOfTheLimbsReachMayTakeTheBody) {
  Animation animation = HoldOn(-0.6);
  animation.holds.pop_back();
  const Error error = BakeError(animation);
  EXPECT_NE(error.message.find("give the hold the reach \"body\""), std::string::npos)
      << error.message;
  animation.holds[0].reach = HoldReach::kBody;
  const Motion motion = BakeOrFail(animation);
  const Vec3 held = OriginOf(animation, motion.frames[0], "r_wrist");
  EXPECT_LE((OriginOf(animation, motion.frames[10], "r_wrist") - held).norm(), 1e-9);
}

TEST(Hold, MayStartLaterAndLetGoInTheAir) {
  Animation animation = Still(Leg());
  animation.root_keys[kRootZ] = {
      {0, 0.9, {}, kCubic}, {10, 0.8, {}, kCubic}, {20, 0.9, {}, kCubic}};
  KeysOf(&animation, "knee") = {{0, 0.7, {}, kCubic}, {30, 0.9, {}, kCubic}};
  KeysOf(&animation, "hip_y") = {{0, -0.4, {}, kCubic}, {30, -0.4, {}, kCubic}};
  KeyTheRest(&animation);
  AddHold(&animation, 4, 14, "toe", false);
  const Motion motion = BakeOrFail(animation);
  const Vec3 held = OriginOf(animation, motion.frames[4], "toe");
  EXPECT_GT((OriginOf(animation, motion.frames[3], "toe") - held).norm(), 1e-3);
  EXPECT_GT((OriginOf(animation, motion.frames[16], "toe") - held).norm(), 1e-3);
  EXPECT_LE((motion.frames[14].before.qd - motion.frames[14].after.qd).norm(), 1e-9);
}

TEST(Pin, ThatStopsTheRootIsWarnedAbout) {
  Animation animation = Still(Human());
  animation.root_keys[kRootX] = {{0, 0.0, 1.0, kCubic}, {10, 0.3, 1.0, kCubic}};
  AddPin(&animation, 10, 20, "l_toe");
  const Motion motion = BakeOrFail(animation);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_NE(motion.warnings[0].message.find("jumps by 1"), std::string::npos);
  EXPECT_NE(motion.warnings[0].message.find("at frame 10"), std::string::npos);
}

TEST(Pin, ThatLeavesTheRootNowhereToGoIsWarnedAbout) {
  Animation animation = Still(Human());
  KeysOf(&animation, "l_knee") = {{0, 0.2, {}, kCubic}, {20, 1.2, {}, kCubic}};
  AddPin(&animation, 0, 10, "l_toe");
  ASSERT_EQ(BakeOrFail(animation).warnings.size(), 1u);
}

TEST(Hold, ThatLeavesAJointNowhereToGoIsWarnedAbout) {
  Animation animation = Sway(false);
  KeysOf(&animation, "r_knee").resize(2);
  const Motion motion = BakeOrFail(animation);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_NE(motion.warnings[0].message.find("\"r_knee\" has no key after frame 5"),
            std::string::npos);
}

TEST(Pin, LeavesPositionAndVelocityToTheRootsCurves) {
  Animation animation = Still(Human());
  KeysOf(&animation, "l_knee") = {{0, 0.2, {}, kCubic}, {20, 1.2, {}, kCubic}};
  animation.root_keys[kRootX] = {{0, 0.0, {}, kCubic}, {25, 0.5, {}, kCubic}};
  KeyTheRest(&animation);
  AddPin(&animation, 0, 10, "l_toe");
  const Motion motion = BakeOrFail(animation);
  EXPECT_GT(motion.frames[10].before.root_v.norm(), 0.05);
  EXPECT_LE((motion.frames[10].before.root_v - motion.frames[10].after.root_v).norm(), 1e-9);
  EXPECT_NEAR(motion.frames[25].X_WR.p.x(), 0.5, 1e-12);
}

}  // namespace
}  // namespace hazumi
