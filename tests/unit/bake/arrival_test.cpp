// Whether constraints that have time to close a gap are told where they do not.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/bake/constraint_cases.h"

namespace hazumi::test {
namespace {

std::vector<Warning> LateIn(const Animation& animation) {
  std::vector<Warning> late;
  for (const Warning& warning : BakeOrFail(animation).warnings) {
    if (warning.place.starts_with("constraints[")) late.push_back(warning);
  }
  return late;
}

TEST(Arrival, OfWhatArrivesNothingIsSaid) {
  for (const Vec3& v0 : {Vec3(0.0, 0.0, 0.0), Vec3(1.0, -2.0, 0.5)}) {
    for (const ConstraintKind kind :
         {ConstraintKind::kPoint, ConstraintKind::kWeld, ConstraintKind::kDistance}) {
      Animation animation = Flying(FreeRod(), kG);
      for (int i = 0; i < 3; ++i) SetRoot(&animation, static_cast<RootCurve>(i), 0.0, v0[i]);
      Constraint& latch =
          AddPoint(&animation, OnRoot(Vec3(0.3, 0.0, 0.02)), InWorld(Vec3(0.4, 0.1, -0.2)), 0, 30);
      latch.kind = kind;
      latch.length = 0.1;
      latch.arrive_frames = 10;
      if (kind == ConstraintKind::kWeld) {
        latch.b.rotation = AxisRotation<double>(Vec3::UnitZ(), std::sin(0.4), std::cos(0.4));
      }
      const std::vector<Warning> late = LateIn(animation);
      EXPECT_TRUE(late.empty()) << NameOf(kind) << ": " << late[0].message;
    }
  }
}

// A chain of 1.2 m does not reach as far as 2 m.
Animation OutOfReach(int first, int last) {
  Animation animation = Chain();
  ConstraintEnd tip = OnJoint(animation, "three");
  tip.offset = 0.4 * Vec3::UnitX();
  AddPoint(&animation, tip, InWorld(Vec3(2.0, 0.0, 0.2)), first, last).arrive_frames = 6;
  return animation;
}

TEST(Arrival, OfWhatIsOutOfReachIsToldWithWhatIsLeft) {
  const Animation animation = OutOfReach(0, 30);
  const std::vector<Warning> late = LateIn(animation);
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].place, "constraints[0]");
  EXPECT_EQ(late[0].frame, 6);
  EXPECT_TRUE(late[0].message.starts_with("\"held\" has not arrived in frame 6: 8"))
      << late[0].message;
  EXPECT_NE(late[0].message.find(" mm of its gap are left, where 8"), std::string::npos)
      << late[0].message;
}

TEST(Arrival, IsLookedAtInItsLastFrameAndNotIfItEndsBefore) {
  EXPECT_EQ(LateIn(OutOfReach(3, 9)).size(), 1u);
  EXPECT_TRUE(LateIn(OutOfReach(3, 8)).empty());
}

TEST(Arrival, IsLookedAtWithoutFramesToo) {
  BakeOptions options;
  options.keep_frames = false;
  const Motion motion = BakeOrFail(OutOfReach(0, 30), options);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_EQ(motion.warnings[0].place, "constraints[0]");
}

TEST(Arrival, OfWhatBreaksOnTheWayIsTold) {
  Animation animation = Flying(FreeRod(), kG);
  Constraint& latch =
      AddPoint(&animation, OnRoot(Vec3::Zero()), InWorld(Vec3(0.4, 0.1, -0.2)), 0, 30);
  latch.arrive_frames = 10;
  latch.break_force = 1.0;
  const std::vector<Warning> late = LateIn(animation);
  ASSERT_EQ(late.size(), 1u);
  EXPECT_NE(late[0].message.find("before it had closed its gap"), std::string::npos)
      << late[0].message;
}

// Straight chain. No joint can draw its tip in, since each moves the tip across the chain.
TEST(Arrival, StraightLimb_GetsAdviceToBend) {
  const auto told = [](const Vec3& to) {
    Animation animation = Chain();
    animation.gravity = 0.0;
    ConstraintEnd tip = OnJoint(animation, "three");
    tip.offset = 0.4 * Vec3::UnitX();
    AddPoint(&animation, tip, InWorld(to), 0, 30).arrive_frames = 6;
    const std::vector<Warning> late = LateIn(animation);
    EXPECT_EQ(late.size(), 1u);
    return late.empty() ? "" : late[0].message;
  };
  EXPECT_NE(told(0.9 * Vec3::UnitX()).find("bend the limb"), std::string::npos);
  EXPECT_EQ(told(2.0 * Vec3::UnitX()).find("bend the limb"), std::string::npos);  // unreachable
}

}  // namespace
}  // namespace hazumi::test
