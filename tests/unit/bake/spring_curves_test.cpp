// Springs whose frequency and strength change over time, and which know what their keys ask for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"

namespace hazumi::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Interpolation kHold = Interpolation::kHold;

Drive SpringTo(SpringTarget target, const DynamicsRegion& region, double frequency,
               double damping_ratio) {
  Drive drive;
  drive.kind = DriveKind::kSpring;
  drive.joints = region.joints;
  drive.target = target;
  drive.frequency = frequency;
  drive.damping_ratio = damping_ratio;
  return drive;
}

// All joints of a figure, on a spring to rest, without gravity.
Animation OnASpring(Figure figure, double frequency, double damping_ratio) {
  Animation animation = Still(std::move(figure));
  animation.gravity = 0.0;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-7 * kDegree;
  DynamicsRegion& region = AddRegion(&animation, "driven", 0, 30, {});
  region.method = Method::kExact;
  for (int j = 0; j < animation.figure->num_joints(); ++j) {
    region.joints.emplace_back(j);
    region.friction.push_back(1.0);
    animation.joint_keys[j] = {{0, 0.5 - 0.1 * j, 0.0, kHold}};
  }
  region.drives = {SpringTo(SpringTarget::kRest, region, frequency, damping_ratio)};
  return animation;
}

void ExpectSame(const Animation& a, const Animation& b) {
  const Motion one = BakeOrFail(a), other = BakeOrFail(b);
  for (size_t i = 0; i < one.frames.size(); ++i) {
    EXPECT_TRUE(IsSame(one.frames[i], other.frames[i])) << i;
  }
}

// On hinges and on a ball joint, in both methods.
TEST(SpringOverTime, OfOneKeyIsTheNumber) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    for (Animation animation : {OnASpring(Chain(3), 2.3, 0.4), OnASpring(FreeArm7(), 2.3, 0.4)}) {
      animation.solver.method = animation.regions[0].method = method;
      animation.solver.step = 1e-3;
      Animation keyed = animation;
      keyed.regions[0].drives[0].frequency = 1.0;
      keyed.regions[0].drives[0].frequency_keys = {{0, 2.3, {}}};
      ExpectSame(animation, keyed);
    }
  }
}

TEST(SpringOverTime, OfOneKeyIsTheShareOfStrength) {
  Animation animation = OnASpring(StrongRod(3.0), 10.0, 1.0);
  animation.gravity = kG;
  animation.regions[0].drives[0].strength = 0.7;
  Animation keyed = animation;
  keyed.regions[0].drives[0].strength.reset();
  keyed.regions[0].drives[0].strength_keys = {{0, 0.7, {}}};
  ExpectSame(animation, keyed);
}

// q = q_0 cos(w t) up to half a second, and from there with the other frequency.
TEST(SpringOverTime, ChangesItsFrequencyWhereTheKeysDo) {
  Animation animation = OnASpring(RodWithin(-1e6, 1e6), 1.0, 0.0);
  animation.regions[0].drives[0].frequency_keys = {{0, 2.0, {}, kHold}, {15, 0.7, {}, kHold}};
  const double w = 4.0 * kPi, v = 1.4 * kPi;
  const double q = 0.5 * std::cos(0.5 * w), qd = -0.5 * w * std::sin(0.5 * w);
  for (const MotionFrame& frame : BakeOrFail(animation).frames) {
    const double t = frame.frame / 30.0, after = t - 0.5;
    const double expected = after < 0.0 ? 0.5 * std::cos(w * t)
                                        : q * std::cos(v * after) + qd / v * std::sin(v * after);
    EXPECT_NEAR(frame.q[0], expected, 1e-7) << frame.frame;
  }
}

// It falls so slowly that the energy stays in proportion to it: the swing widens as w^(-1/2).
TEST(SpringOverTime, FollowsItsFrequencyBetweenKeys) {
  Animation animation = OnASpring(RodWithin(-1e6, 1e6), 1.0, 0.0);
  animation.regions[0].drives[0].frequency_keys = {{0, 5.0, {}, Interpolation::kLinear},
                                                   {30, 3.0, {}, Interpolation::kLinear}};
  const MotionFrame end = BakeOrFail(animation).frames.back();
  const double w = 6.0 * kPi, swing = std::hypot(end.q[0], end.after.qd[0] / w);
  EXPECT_NEAR(swing, 0.5 * std::sqrt(5.0 / 3.0), 0.02);
}

// With no strength left it goes on as fast as it is.
TEST(SpringOverTime, IsAsStrongAsTheKeysSay) {
  Animation animation = OnASpring(StrongRod(0.5), 10.0, 0.0);
  animation.regions[0].drives[0].strength_keys = {{0, 1.0, {}, kHold}, {10, 0.0, {}, kHold}};
  const Motion motion = BakeOrFail(animation);
  const double rate = motion.frames[10].after.qd[0];
  EXPECT_GT(std::abs(rate), 0.1);
  for (size_t i = 10; i < motion.frames.size(); ++i) {
    EXPECT_NEAR(motion.frames[i].after.qd[0], rate, 1e-9) << i;
  }
}

// The throw's figure, which moves all over; its right arm is on weak springs that know what the
// keys ask for, with friction.
Animation WithAnArm(double frequency, double friction) {
  FigureSpec spec = LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value();
  for (JointSpec& joint : spec.joints) {
    for (HingeSpec& hinge : joint.hinges) {
      hinge.lower = -1000.0;
      hinge.upper = 1000.0;
    }
  }
  Animation animation = Still(BuildFigure(spec).value());
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-6 * kDegree;
  double value = 0.2;
  for (Keys& keys : animation.joint_keys) {
    for (const double frame : {0.0, 8.0, 17.0, 30.0}) {
      value = std::fmod(value * 7.3 + 0.37, 1.0);
      keys.push_back({frame, 0.6 * (value - 0.4), {}});
    }
  }
  for (const int angle : {kRootAngleZ, kRootAngleY, kRootAngleX}) {
    animation.root_keys[angle] = {{0, 0.1, {}}, {12, 0.3, {}}, {30, -0.2, {}}};
  }
  animation.root_keys[kRootX] = {{0, 0.0, {}}, {12, 0.5, {}}, {30, 0.6, {}}};
  animation.root_keys[kRootZ] = {{0, 2.0, 3.0}, {30, 1.5, {}}};
  DynamicsRegion& region = AddRegion(&animation, "arm", 5, 25, {"r_shoulder"}, friction);
  region.method = Method::kExact;
  region.drives = {SpringTo(SpringTarget::kKeys, region, frequency, 1.0)};
  region.drives[0].feed_forward = true;
  return animation;
}

// The greatest angle between the keys' joints and the springs' [degrees].
double FurthestOff(const Animation& animation) {
  Animation keyed = animation;
  keyed.regions.clear();
  const Motion springs = BakeOrFail(animation), truth = BakeOrFail(keyed);
  double most = 0.0;
  for (size_t i = 5; i <= 25; ++i) {
    for (const JointIndex j : animation.regions[0].joints) {
      const double off = springs.frames[i].q[j.value()] - truth.frames[i].q[j.value()];
      most = std::max(most, std::abs(off));
    }
  }
  return most / kDegree;
}

TEST(FeedForward, KeepsAWeakSpringOnItsKeys) {
  for (const double friction : {1.0, 0.8}) {
    Animation animation = WithAnArm(1.0, friction);
    EXPECT_LT(FurthestOff(animation), 1e-4) << friction;
    animation.regions[0].drives[0].feed_forward = false;
    EXPECT_GT(FurthestOff(animation), 10.0) << friction;
  }
}

TEST(FeedForward, KeepsItThereWhileAHandIsPinnedToo) {
  Animation animation = WithAnArm(1.0, 0.8);
  AddPin(&animation, 0, 30, "r_wrist");
  EXPECT_LT(FurthestOff(animation), 1e-3);
}

TEST(FeedForward, KeepsItThereInFlight) {
  Animation animation = WithAnArm(1.0, 0.8);
  AddGravity(&animation, 0, 30);
  EXPECT_LT(FurthestOff(animation), 1e-3);
}

TEST(FeedForward, KeepsItThereInThePapersSteps) {
  Animation animation = WithAnArm(1.0, 0.8);
  animation.solver.method = animation.regions[0].method = Method::kPaper;
  animation.solver.step = 1e-4;
  EXPECT_LT(FurthestOff(animation), 0.1);
}

// What is limited sags: it is weaker than the arm's weight.
TEST(FeedForward, IsLimitedWithThePull) {
  Animation animation = WithAnArm(1.0, 0.8);
  animation.regions[0].drives[0].max_torque = 2.0;
  EXPECT_GT(FurthestOff(animation), 5.0);
}

// A jump of the keys asks for no torque without bound: the spring alone goes after it.
TEST(FeedForward, IsWithoutAKickWhereKeysJump) {
  Animation animation = OnASpring(RodWithin(-1e6, 1e6), 3.0, 1.0);
  animation.joint_keys[0] = {{0, 0.0, 0.0, kHold}, {10, 0.4, {}, kHold}};
  Drive& drive = animation.regions[0].drives[0];
  drive.target = SpringTarget::kKeys;
  drive.feed_forward = true;
  Animation without = animation;
  without.regions[0].drives[0].feed_forward = false;
  const Motion a = BakeOrFail(animation), b = BakeOrFail(without);
  for (size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_NEAR(a.frames[i].q[0], b.frames[i].q[0], 1e-8) << i;
  }
}

}  // namespace
}  // namespace hazumi::test
