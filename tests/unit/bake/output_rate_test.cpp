// A motion looked at at other rates than the animation's.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

// Something of everything: holds, a pin, a region, then a jump.
Animation Everything(double step) {
  Animation animation = Still(Human());
  animation.solver.step = step;
  animation.root_keys[kRootZ] = {{0, 0.90, {}, kCubic}, {5, 0.86, {}, kCubic}};
  for (const char* joint : {"r_hip_y", "l_hip_y"}) {
    KeysOf(&animation, joint) = {
        {0, -0.4, {}, kCubic}, {5, -0.5, {}, kCubic}, {15, -0.3, {}, kCubic}};
  }
  for (const char* joint : {"r_knee", "l_knee"}) {
    KeysOf(&animation, joint) = {{0, 0.8, {}, kCubic}, {5, 1.0, {}, kCubic}, {15, 0.6, {}, kCubic}};
  }
  AddHold(&animation, 0, 5, "r_toe", false);
  AddHold(&animation, 0, 5, "l_toe", false);
  AddPin(&animation, 5, 12, "l_toe");
  AddGravity(&animation, 12, 30);
  AddFloor(&animation, -0.3);
  AddRegion(&animation, "arms", 5, 20, {"r_shoulder", "l_shoulder"});
  return animation;
}

Motion At(const Animation& animation, int num, int den) {
  BakeOptions options;
  options.output_rate = FrameRate{num, den};
  return BakeOrFail(animation, options);
}

double StepSize(const MotionFrame& a, const MotionFrame& b) {
  return (a.q - b.q).cwiseAbs().maxCoeff() + (a.X_WR.p - b.X_WR.p).norm();
}

TEST(OutputRate, HasEveryFrameOnce) {
  for (const double step : {1.0 / 30.0, 1.0 / 60.0, 1.0 / 90.0, 0.013}) {
    const Animation animation = Everything(step);
    const std::tuple<int, int, int> cases[] = {{60, 1, 61},   {24, 1, 25}, {30000, 1001, 30},
                                               {120, 1, 121}, {90, 1, 91}, {30, 1, 31}};
    for (const auto& [num, den, count] : cases) {
      const Motion motion = At(animation, num, den);
      ASSERT_EQ(motion.frames.size(), static_cast<size_t>(count)) << num << "/" << den;
      for (int f = 0; f < count; ++f) EXPECT_EQ(motion.frames[f].frame, f);
    }
  }
}

TEST(OutputRate, CoincidingInstantsAreBitEqual) {
  for (const double step : {1.0 / 30.0, 1.0 / 60.0, 0.013}) {
    const Animation animation = Everything(step);
    const Motion own = BakeOrFail(animation), doubled = At(animation, 60, 1);
    for (int f = 0; f <= 30; ++f) {
      MotionFrame frame = doubled.frames[2 * f];
      EXPECT_TRUE(IsSame(frame, own.frames[f])) << f;
    }
    const Motion film = At(animation, 24, 1);
    for (int f = 0; f <= 30; f += 5) EXPECT_TRUE(IsSame(film.frames[f * 4 / 5], own.frames[f]));
  }
}

TEST(OutputRate, FramesBetweenLieBetween) {
  const Animation animation = Everything(1.0 / 30.0);
  const Motion own = BakeOrFail(animation), doubled = At(animation, 60, 1);
  for (int f = 0; f < 30; ++f) {
    const double whole = StepSize(own.frames[f], own.frames[f + 1]);
    const MotionFrame& middle = doubled.frames[2 * f + 1];
    EXPECT_LE(StepSize(own.frames[f], middle), 0.8 * whole + 1e-3) << f;
    EXPECT_LE(StepSize(middle, own.frames[f + 1]), 0.8 * whole + 1e-3) << f;
  }
}

TEST(OutputRate, KeepsHoldsAndPinsExact) {
  const Animation animation = Everything(1.0 / 30.0);
  const Motion motion = At(animation, 120, 1);
  const Vec3 toe = OriginOf(animation, motion.frames[0], "l_toe");
  for (int f = 0; f <= 12 * 4; ++f) {
    EXPECT_LE((OriginOf(animation, motion.frames[f], "l_toe") - toe).norm(), 1e-9) << f;
  }
}

// A held toe, then a pinned one, then gravity: the CoM falls on one parabola at any rate.
TEST(OutputRate, KeepsFlightExact) {
  const Animation animation = Everything(1.0 / 30.0);
  const Motion motion = At(animation, 120, 1);
  const int landing = EventsOf(motion, EventKind::kLanding).at(0).frame / 4 * 4;
  for (int f = 12 * 4 + 2; f <= landing; ++f) {
    const Vec3 second =
        motion.frames[f].com - 2.0 * motion.frames[f - 1].com + motion.frames[f - 2].com;
    EXPECT_LE((second * 14400.0 - Vec3(0, 0, -9.81)).norm(), 1e-6) << f;
  }
  EXPECT_GT(landing, 12 * 4 + 20);
  EXPECT_TRUE(motion.frames.back().pinned.has_value());
}

TEST(OutputRate, EventsCountInItsFrames) {
  const Animation animation = Everything(1.0 / 30.0);
  const auto own = EventsOf(BakeOrFail(animation), EventKind::kLanding);
  const auto doubled = EventsOf(At(animation, 60, 1), EventKind::kLanding);
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(doubled.size(), 1u);
  EXPECT_EQ(own[0].time, doubled[0].time);
  EXPECT_EQ(own[0].frame, std::ceil(own[0].time * 30.0));
  EXPECT_EQ(doubled[0].frame, std::ceil(own[0].time * 60.0));
}

}  // namespace
}  // namespace hazumi
