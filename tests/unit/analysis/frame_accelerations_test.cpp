// Torques of motions without accelerations of the bake, from cubics between frames.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/effort.h"
#include "engine/analysis/smooth_motion.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

constexpr double kMass = 3.0, kRadius = 0.05, kLength = 0.8;

Animation PendulumWith(const Keys& keys) {
  Animation animation = Still(Pendulum(kMass, kRadius, kLength));
  animation.joint_keys[0] = keys;
  return animation;
}

std::vector<FrameEffort> EffortsOf(const Animation& animation) {
  return EffortOf(animation, BakeOrFail(animation)).frames;
}

double GravityTorque(double angle) { return kMass * kG * 0.5 * kLength * std::sin(angle); }

TEST(FrameAccelerations, HeldPendulum_HasNoAccelerations) {
  const Animation animation = PendulumWith({{0, 1.2, 0.0, kCubic}});
  for (const FrameEffort& effort : EffortsOf(animation)) {
    EXPECT_NEAR(effort.tau[0], GravityTorque(1.2), 1e-9);
    EXPECT_NEAR(effort.from_nowhere.force.z(), kMass * kG, 1e-9);
  }
}

TEST(FrameAccelerations, KeyedMotion_MatchesItsCurveToTheLastFrame) {
  const double a = 0.3, b = 1.4, T = 1.0;
  const Animation animation = PendulumWith({{0, a, 0.0, kCubic}, {30, b, 0.0, kCubic}});
  const std::vector<FrameEffort> torques = EffortsOf(animation);
  const double inertia =
      kMass * (3.0 * kRadius * kRadius + 4.0 * kLength * kLength) / 12.0;  // about the pivot
  for (int f = 0; f <= 30; ++f) {
    const double s = f / 30.0;
    const double q = a + (b - a) * s * s * (3.0 - 2.0 * s);
    const double qdd = (b - a) * (6.0 - 12.0 * s) / (T * T);
    EXPECT_NEAR(torques[f].tau[0], inertia * qdd + GravityTorque(q), 1e-9) << f;
  }
}

// Largest torque of any hinge of arms that swing freely.
double LargestOfASwing(int frames_per_second) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_shoulder_y") = {{0, 0.9, 0.0, kCubic}};
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 1.0).method = Method::kExact;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9;
  BakeOptions options;
  options.output_rate = FrameRate{frames_per_second, 1};
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  const std::vector<FrameEffort> torques = EffortOf(animation, motion).frames;
  double largest = 0.0;
  for (size_t i = 0; i + 1 < motion.frames.size(); ++i) {
    for (int j = 0; j < torques[i].tau.size(); ++j) {
      if (motion.frames[i].in_region[j]) largest = std::max(largest, std::abs(torques[i].tau[j]));
    }
  }
  return largest;
}

TEST(FrameAccelerations, FreeSwing_HasErrorsOfSecondOrderInTheFrameTime) {
  const double coarse = LargestOfASwing(60), fine = LargestOfASwing(240);
  EXPECT_GT(coarse, 0.0);
  EXPECT_LT(fine, coarse / 13.0);
  EXPECT_LT(fine, 0.02);
}

// Ball that is part of its holder's body until its release.
TEST(Effort, HandThatHoldsABall_CarriesItsWeight) {
  Animation animation = Still(Human37());
  KeysOf(&animation, "r_shoulder_y") = {{0, -1.5, 0.0, kCubic}};
  const FrameEffort without = EffortsOf(animation)[0];
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{0.05};
  ball.mass = 0.5;
  ball.holders = {{GroupOf(animation, "r_wrist"), Vec3::Zero(), Holder::kFromTheStart, 15}};
  animation.held_objects.push_back(ball);
  const Motion motion = BakeOrFail(animation);
  const std::vector<FrameEffort> with = EffortOf(animation, motion).frames;
  const Vec3 arm = OriginOf(animation, motion.frames[0], "r_wrist") -
                   OriginOf(animation, motion.frames[0], "r_shoulder");
  const int flexion = JointOf(animation, "r_shoulder_y").value();
  EXPECT_NEAR(std::abs(with[0].tau[flexion] - without.tau[flexion]), 0.5 * kG * std::abs(arm.x()),
              1e-9);
  EXPECT_NEAR(with[15].tau[flexion], without.tau[flexion], 1e-9);
}

}  // namespace
}  // namespace hazumi::test
