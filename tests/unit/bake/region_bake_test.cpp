// Dynamics regions in a bake: how they begin, how they end, how they add up.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure_builder.h"
#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

constexpr Interpolation kHold = Interpolation::kHold;
constexpr Interpolation kLinear = Interpolation::kLinear;

// The human with both arms raised and a region of the right one.
Animation RightArmSwings(int first, int last) {
  Animation animation = Still(Human());
  KeysOf(&animation, "r_shoulder_y") = {
      {0, -0.2, {}, kCubic}, {5, -1.2, {}, kCubic}, {15, 0.3, {}, kLinear}, {30, 0.0, {}, kCubic}};
  KeysOf(&animation, "r_elbow_y") = {
      {0, -1.5, {}, kCubic}, {5, -1.0, {}, kCubic}, {15, -0.4, {}, kCubic}, {30, -0.2, {}, kCubic}};
  KeysOf(&animation, "l_shoulder_y") = {{0, 0.5, {}, kCubic}, {30, -0.5, {}, kCubic}};
  AddRegion(&animation, "right", first, last, {"r_shoulder"}, 0.8);
  KeyTheRest(&animation);
  return animation;
}

double RateOf(const Animation& animation, const MotionLimit& rates, const char* joint) {
  return rates.qd[JointOf(animation, joint).value()];
}

void ExpectContinuous(const MotionFrame& frame) {
  EXPECT_LE((frame.before.q - frame.after.q).cwiseAbs().maxCoeff(), 1e-9) << frame.frame;
  EXPECT_LE((frame.before.X_WR.p - frame.after.X_WR.p).norm(), 1e-9) << frame.frame;
  EXPECT_LE((frame.before.qd - frame.after.qd).cwiseAbs().maxCoeff(), 1e-9) << frame.frame;
  EXPECT_LE((frame.before.root_v - frame.after.root_v).norm(), 1e-9) << frame.frame;
  EXPECT_LE((frame.before.root_w - frame.after.root_w).norm(), 1e-9) << frame.frame;
}

TEST(Region, StartsWithTheKeysRateIfGiven) {
  Animation animation = RightArmSwings(5, 15);
  KeysOf(&animation, "r_shoulder_y")[1].rate = -3.5;
  const Motion motion = BakeOrFail(animation);
  EXPECT_EQ(RateOf(animation, motion.frames[5].after, "r_shoulder_y"), -3.5);
}

TEST(Region, StartsWithTheLeftDerivativeOfTheCurveElse) {
  const Animation animation = RightArmSwings(5, 15);
  const Motion motion = BakeOrFail(animation);
  // A parabola from rest arrives at twice the mean rate.
  EXPECT_NEAR(RateOf(animation, motion.frames[5].after, "r_shoulder_y"), -2.0 * 6.0, 1e-9);
  ExpectContinuous(motion.frames[5]);
}

// Nothing of the first region is left in the error estimate of the second.
TEST(Region, MayFreeAJointOnceMore) {
  Animation animation = RightArmSwings(5, 10);
  animation.solver.method = Method::kExact;
  AddRegion(&animation, "again", 20, 25, {"r_shoulder"}, 0.8);
  for (DynamicsRegion& region : animation.regions) region.method = Method::kExact;
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(motion.warnings.empty());
  for (const RegionReport& region : motion.regions) {
    EXPECT_LE(region.error_estimate, region.tolerance);
  }
}

TEST(Region, StartsBetweenKeysWithTheLeftDerivativeOfTheCurve) {
  Animation keyed = RightArmSwings(3, 15);
  const Motion motion = BakeOrFail(keyed);
  keyed.regions.clear();
  const Motion curves = BakeOrFail(keyed);
  EXPECT_NEAR(RateOf(keyed, motion.frames[3].after, "r_shoulder_y"),
              RateOf(keyed, curves.frames[3].before, "r_shoulder_y"), 1e-12);
  EXPECT_NE(RateOf(keyed, motion.frames[3].after, "r_shoulder_y"), 0.0);
}

TEST(Region, StartsAtRestOnTheFirstFrame) {
  Animation animation = RightArmSwings(0, 15);
  KeysOf(&animation, "r_shoulder_y")[0].interpolation = kLinear;
  const Motion motion = BakeOrFail(animation);
  EXPECT_EQ(RateOf(animation, motion.frames[0].after, "r_shoulder_y"), 0.0);
}

TEST(Region, LeavesAngleAndRateToTheCurve) {
  const Animation animation = RightArmSwings(5, 15);
  const Motion motion = BakeOrFail(animation);
  ExpectContinuous(motion.frames[15]);
  EXPECT_GT(std::abs(RateOf(animation, motion.frames[15].after, "r_shoulder_y")), 0.1);
  EXPECT_NEAR(motion.frames[30].q[JointOf(animation, "r_shoulder_y").value()], 0.0, 1e-12);
}

TEST(Region, KeysInsideAndAtItsEndChangeNothing) {
  Animation animation = RightArmSwings(5, 15), changed = animation;
  Keys& keys = KeysOf(&changed, "r_shoulder_y");
  keys[2] = {15, 1.1, 9.0, kHold};
  keys.insert(keys.begin() + 2, {8.5, -0.9, {}, kLinear});
  const Motion one = BakeOrFail(animation), other = BakeOrFail(changed);
  for (int f = 0; f <= 30; ++f) EXPECT_TRUE(IsSame(one.frames[f], other.frames[f])) << f;
}

// The right arm swings as a wave that is keyed on every frame, as a capture is.
Animation RightArmIsRecorded(int blend_frames) {
  Animation animation = Still(Human());
  for (const char* joint : {"r_shoulder_y", "r_shoulder_x", "r_elbow_y"}) {
    const double phase = joint[8];
    for (int f = 0; f <= 30; ++f) {
      KeysOf(&animation, joint)
          .push_back({1.0 * f, -0.6 + 0.4 * std::sin(0.4 * f + phase), {}, kCubic});
    }
  }
  KeyTheRest(&animation);
  AddRegion(&animation, "right", 5, 15, {"r_shoulder"}, 0.8).blend_frames = blend_frames;
  return animation;
}

TEST(Region, StartsWithTheRateThatWasRecorded) {
  const Animation animation = RightArmIsRecorded(0);
  const Motion motion = BakeOrFail(animation);
  for (const char* joint : {"r_shoulder_y", "r_shoulder_x", "r_elbow_y"}) {
    const double rate = 30.0 * 0.4 * 0.4 * std::cos(0.4 * 5 + joint[8]);
    EXPECT_NEAR(RateOf(animation, motion.frames[5].after, joint), rate, 0.03 * 4.8) << joint;
  }
}

TEST(Region, BlendsBackIntoTheRecordingWithoutAJump) {
  Animation clip = RightArmIsRecorded(0);
  clip.regions.clear();
  const Motion recorded = BakeOrFail(clip);
  for (const Method method : {Method::kPaper, Method::kExact}) {
    Animation animation = RightArmIsRecorded(6);
    animation.solver.method = animation.regions[0].method = method;
    const Motion motion = BakeOrFail(animation);
    for (int f = 1; f <= 29; ++f) ExpectContinuous(motion.frames[f]);
    EXPECT_GT((motion.frames[18].q - recorded.frames[18].q).norm(), 0.01);
    for (const char* joint : {"r_shoulder_y", "r_shoulder_x", "r_elbow_y"}) {
      for (int f = 21, j = JointOf(animation, joint).value(); f <= 30; ++f) {
        EXPECT_NEAR(motion.frames[f].q[j], recorded.frames[f].q[j], 1e-12) << f;
        EXPECT_NEAR(motion.frames[f].after.qd[j], recorded.frames[f].after.qd[j], 1e-9) << f;
      }
    }
  }
}

TEST(Region, ARegionThatBeginsInABlendTakesItOver) {
  Animation animation = RightArmIsRecorded(8);
  const Motion alone = BakeOrFail(animation);
  AddRegion(&animation, "again", 18, 22, {"r_shoulder"}, 0.8);
  const Motion motion = BakeOrFail(animation);
  for (int f = 0; f < 18; ++f) EXPECT_TRUE(IsSame(motion.frames[f], alone.frames[f])) << f;
  ExpectContinuous(motion.frames[18]);
  EXPECT_EQ(RateOf(animation, motion.frames[18].after, "r_elbow_y"),
            RateOf(animation, alone.frames[18].before, "r_elbow_y"));
}

// A pendulum below its root, whose hinge is keyed at 0.1 rad on every frame, is swung round.
Animation PendulumTurnsRound(double rate, double lower) {
  FigureSpec spec;
  spec.root_name = "root";
  LinkSpec body, rod;
  body.name = "body";
  body.to = Vec3(0.0, 0.0, 0.1);
  rod.name = "rod";
  rod.to = Vec3(0.0, 0.0, -0.4);
  body.radius = rod.radius = 0.04;
  body.mass = rod.mass = 2.0;
  spec.root_links.push_back(body);
  HingeSpec hinge;
  hinge.axis = Vec3::UnitY();
  hinge.lower = lower;
  hinge.upper = 100.0;
  JointSpec joint;
  joint.name = "hinge";
  joint.parent = "root";
  joint.hinges.push_back(hinge);
  joint.links.push_back(rod);
  spec.joints.push_back(joint);
  Animation animation = Still(BuildFigure(spec).value());
  Keys& keys = KeysOf(&animation, "hinge");
  for (int f = 0; f <= 30; ++f) keys.push_back({1.0 * f, 0.1, {}, kCubic});
  keys[3].rate = rate;
  AddRegion(&animation, "swing", 3, 15, {"hinge"}).blend_frames = 8;
  animation.solver.method = animation.regions[0].method = Method::kExact;
  return animation;
}

TEST(Region, ABlendLeavesWholeTurnsBehindButNotThroughALimit) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const Motion free = BakeOrFail(PendulumTurnsRound(26.0, -100.0));
  const double swung = free.frames[14].q[0] + free.frames[14].after.qd[0] / 30.0;
  const double resumed = free.frames[15].q[0];
  ASSERT_GT(swung, kTurn);
  EXPECT_LE(std::abs(resumed - 0.1), 0.5 * kTurn);
  EXPECT_NEAR(std::remainder(swung - resumed, kTurn), 0.0, 0.1);
  EXPECT_EQ(free.frames[15].before.qd[0], free.frames[15].after.qd[0]);
  EXPECT_NEAR(free.frames[23].q[0], 0.1, 1e-12);
  // With a limit that is in the way.
  ASSERT_LT(resumed, 0.0);
  const Motion stopped = BakeOrFail(PendulumTurnsRound(26.0, resumed + 0.01));
  EXPECT_NEAR(stopped.frames[15].q[0] - resumed, kTurn * std::round((swung - resumed) / kTurn),
              1e-9);
  EXPECT_NEAR(stopped.frames[23].q[0], 0.1, 1e-12);
}

TEST(Region, HandsOverToATouchingOne) {
  Animation animation = RightArmSwings(5, 10);
  AddRegion(&animation, "after", 10, 15, {"r_shoulder"}, 0.8);
  KeysOf(&animation, "r_shoulder_y")
      .insert(KeysOf(&animation, "r_shoulder_y").begin() + 2, Key{10, 0.7, 5.0, kCubic});
  const Motion two = BakeOrFail(animation), one = BakeOrFail(RightArmSwings(5, 15));
  for (int f = 0; f <= 30; ++f) EXPECT_TRUE(IsSame(two.frames[f], one.frames[f])) << f;
}

// The trunk is keyed, so the arms do not feel each other.
TEST(Region, OfAnotherLimbChangesNothing) {
  const Animation right = RightArmSwings(5, 15);
  Animation left = right, both = right;
  left.regions.clear();
  for (Animation* animation : {&left, &both}) AddRegion(animation, "left", 8, 21, {"l_shoulder"});
  const Motion motion = BakeOrFail(both), of_right = BakeOrFail(right), of_left = BakeOrFail(left);
  for (int f = 0; f <= 30; ++f) {
    for (int j = 0; j < both.figure->num_joints(); ++j) {
      const bool is_left = both.figure->joints()[j].name.starts_with("l_");
      const Motion& alone = is_left ? of_left : of_right;
      EXPECT_NEAR(motion.frames[f].q[j], alone.frames[f].q[j], 1e-9) << f << " joint " << j;
    }
  }
}

TEST(Region, TwoBakesAreBitEqual) {
  Animation animation = RightArmSwings(5, 15);
  AddHold(&animation, 0, 5, "r_toe", true);
  AddPin(&animation, 5, 30, "l_toe");
  const Motion one = BakeOrFail(animation), other = BakeOrFail(animation);
  for (int f = 0; f <= 30; ++f) EXPECT_TRUE(IsSame(one.frames[f], other.frames[f])) << f;
}

// The pendulum TwoLinks has at its foot: no gravity, so that only friction acts.
TEST(Region, MovesItsJointsInItsIntervalAndLeavesTheRestToTheirKeys) {
  for (const Method method : {Method::kPaper, Method::kExact}) {
    Animation animation = RightArmSwings(5, 15);
    animation.regions[0].method = method;
    const Motion motion = BakeOrFail(animation);
    Animation keyed = animation;
    keyed.regions.clear();
    const Motion curves = BakeOrFail(keyed);
    const std::vector<JointIndex>& freed = animation.regions[0].joints;
    for (int f = 0; f <= 30; ++f) {
      for (int j = 0; j < animation.figure->num_joints(); ++j) {
        const bool is_free = std::count(freed.begin(), freed.end(), JointIndex(j)) > 0;
        if (is_free && f != 5 && f != 30) continue;  // those have keys at both
        EXPECT_NEAR(motion.frames[f].q[j], curves.frames[f].q[j], 1e-12) << f << " joint " << j;
      }
    }
    for (const char* joint : {"r_shoulder_y", "r_elbow_y"}) {
      const int j = JointOf(animation, joint).value();
      EXPECT_GT(std::abs(motion.frames[10].q[j] - curves.frames[10].q[j]), 0.05) << joint;
    }
  }
}

// Without gravity nothing else moves a hinge that turns alone.
TEST(Region, HasAFrictionForEachOfItsJoints) {
  for (const Method method : {Method::kPaper, Method::kExact}) {
    Animation animation = Still(Human());
    animation.gravity = 0.0;
    const std::pair<const char*, double> factors[] = {{"r_elbow_y", 0.8}, {"l_elbow_y", 0.4}};
    DynamicsRegion region;
    region.name = "elbows";
    region.last_frame = 10;
    region.method = method;
    for (const auto& [joint, factor] : factors) {
      KeysOf(&animation, joint) = {{0, -1.0, 0.5, kCubic}, {30, -1.0, {}, kCubic}};
      region.joints.push_back(JointOf(animation, joint));
      region.friction.push_back(factor);
    }
    animation.regions.push_back(region);
    const Motion motion = BakeOrFail(animation);
    for (const auto& [joint, factor] : factors) {
      EXPECT_NEAR(RateOf(animation, motion.frames[10].before, joint), 0.5 * std::pow(factor, 10.0),
                  1e-4)
          << joint;
    }
  }
}

TEST(Region, FrictionIsAFactorPerThirtiethOfASecondAtAnyStep) {
  for (const double step : {1.0 / 30.0, 1.0 / 45.0, 1.0 / 100.0, 1.0 / 240.0}) {
    Animation animation = Still(TwoLinks());
    animation.gravity = 0.0;
    animation.solver.step = step;
    KeysOf(&animation, "foot") = {{0, 0, 2.0, kCubic}, {30, 0, {}, kCubic}};
    AddRegion(&animation, "swing", 0, 10, {"foot"}, 0.8);
    const Motion motion = BakeOrFail(animation);
    EXPECT_NEAR(RateOf(animation, motion.frames[10].before, "foot"), 2.0 * std::pow(0.8, 10.0),
                1e-12);
  }
}

TEST(Region, TakesAsManyStepsAsTheFrameTimeNeeds) {
  const std::pair<double, int> cases[] = {{1.0 / 30.0, 1}, {0.1, 1},   {1.0 / 60.0, 2},
                                          {1.0 / 45.0, 2}, {0.013, 3}, {1.0 / 300.0, 10}};
  for (const auto& [step, per_frame] : cases) {
    Animation animation = RightArmSwings(5, 15);
    animation.solver.step = step;
    const Motion motion = BakeOrFail(animation);
    EXPECT_EQ(motion.regions[0].steps, 10 * per_frame) << step;
    EXPECT_EQ(motion.regions[0].evaluations, 10 * per_frame);
    EXPECT_EQ(motion.regions[0].free_joints, 7);
    ExpectContinuous(motion.frames[5]);
    ExpectContinuous(motion.frames[15]);
  }
}

TEST(Region, ItsOwnStepWins) {
  Animation animation = RightArmSwings(5, 15);
  animation.regions[0].step = 1.0 / 120.0;
  EXPECT_EQ(BakeOrFail(animation).regions[0].steps, 40);
}

TEST(Region, KeepsThePinnedJointInPlace) {
  Animation animation = RightArmSwings(5, 15);
  KeysOf(&animation, "l_knee") = {{5, 0.2, {}, kCubic}, {20, 0.9, {}, kCubic}};
  AddPin(&animation, 5, 30, "l_toe");
  const Motion motion = BakeOrFail(animation);
  const Vec3 toe = OriginOf(animation, motion.frames[5], "l_toe");
  for (int f = 5; f <= 30; ++f) {
    const MotionFrame& frame = motion.frames[f];
    EXPECT_LE((OriginOf(animation, frame, "l_toe") - toe).norm(), 1e-12) << f;
    EXPECT_LE(VelocityOf(animation, frame, frame.after, "l_toe").norm(), 1e-12) << f;
  }
  EXPECT_GT((motion.frames[20].X_WR.p - motion.frames[5].X_WR.p).norm(), 0.01);
}

TEST(Region, ThatExplodesIsAnErrorWithJointAndFrame) {
  Animation animation = RightArmSwings(5, 15);
  KeysOf(&animation, "r_shoulder_y")[1].rate = 1e7;
  const Error error = BakeError(animation);
  EXPECT_EQ(error.code, ErrorCode::kSemantics);
  EXPECT_NE(error.message.find("joint \"r_"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("after frame "), std::string::npos) << error.message;
}

TEST(Region, WithoutAKeyAfterItIsWarnedAbout) {
  Animation animation = RightArmSwings(5, 15);
  KeysOf(&animation, "r_shoulder_y").pop_back();
  const Motion motion = BakeOrFail(animation);
  int count = 0;
  for (const Warning& warning : motion.warnings) {
    count +=
        warning.message.find("\"r_shoulder_y\" has no key after frame 15") != warning.message.npos;
  }
  EXPECT_EQ(count, 1);
}

TEST(Region, LimitsAreEvents) {
  Animation animation = Still(TwoLinks());
  KeysOf(&animation, "knee") = {{0, 2.9, 3.0, kCubic}, {30, 0, {}, kCubic}};
  animation.gravity = 0.0;
  AddRegion(&animation, "swing", 0, 10, {"knee"});
  const Motion motion = BakeOrFail(animation);
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_EQ(limits[0].joint, "knee");
  EXPECT_EQ(limits[0].frame, 2);
}

}  // namespace
}  // namespace hazumi
