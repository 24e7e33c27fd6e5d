// A human in the air: what no inner force can change, baked to a billionth of a degree.

#include <gtest/gtest.h>

#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/compare.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

constexpr int kLast = 60;  // 2 s

void SetStart(Animation* animation, int joint, double angle, double rate) {
  animation->joint_keys[joint] = {{0, angle, rate, Interpolation::kHold}};
}

// Both arms swing and the root turns, the rest is held.
Animation Swinging(double friction, double speed) {
  Animation animation = Still(LimberHuman());
  animation.last_frame = kLast;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-9 * kDegree;
  DynamicsRegion& region =
      AddRegion(&animation, "arms", 0, kLast, {"r_shoulder", "l_shoulder"}, friction);
  region.root = true;
  region.method = Method::kExact;
  double value = 0.3;
  for (const JointIndex j : region.joints) {
    value = std::fmod(value * 7.3 + 0.37, 1.0);
    SetStart(&animation, j.value(), value - 0.2, 8.0 * speed * (value - 0.5));
  }
  animation.root_keys[kRootAngleZ] = {{0, 0.4, 2.0 * speed, Interpolation::kHold}};
  animation.root_keys[kRootAngleY] = {{0, 0.2, 5.0 * speed, Interpolation::kHold}};
  animation.root_keys[kRootAngleX] = {{0, -0.1, -1.0 * speed, Interpolation::kHold}};
  return animation;
}

// With twist and somersault.
Animation Thrown(double friction, double speed) {
  Animation animation = Swinging(friction, speed);
  animation.root_keys[kRootX] = {{0, 0.0, 1.3, Interpolation::kHold}};
  animation.root_keys[kRootZ] = {{0, 2.0, 9.0, Interpolation::kHold}};
  AddGravity(&animation, 0, kLast);
  return animation;
}

struct Drift {
  double com = 0.0, L = 0.0, energy = 0.0;  // [m], relative, relative
  double turned = 0.0;                      // how far the arms and the root went [rad]
};

double EnergyOf(const Momentum& m) { return m.kinetic + m.potential(kG); }

Drift DriftOf(const Animation& animation, const Motion& motion) {
  const Momentum start = MomentumOf(*animation.figure, motion.frames[0].after);
  Drift drift;
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    for (const MotionLimit* side : {&frame.before, &frame.after}) {
      if (frame.frame == 0 && side == &frame.before) continue;
      const Momentum now = MomentumOf(*animation.figure, *side);
      const Vec3 com = start.com + start.com_v * t - 0.5 * kG * t * t * Vec3::UnitZ();
      drift.com = std::max(drift.com, (now.com - com).norm());
      drift.L = std::max(drift.L, (now.L - start.L).norm() / start.L.norm());
      drift.energy =
          std::max(drift.energy, std::abs(EnergyOf(now) - EnergyOf(start)) / start.kinetic);
    }
    drift.turned = std::max(drift.turned, (frame.q - motion.frames[0].q).lpNorm<Eigen::Infinity>());
  }
  return drift;
}

TEST(FlightBake, KeepsParabolaAngularMomentumAndEnergyForTwoSeconds) {
  const Animation animation = Thrown(1.0, 0.4);
  const Motion motion = BakeOrFail(animation);
  ASSERT_EQ(motion.frames.size(), kLast + 1u);
  EXPECT_GT(MomentumOf(*animation.figure, motion.frames[0].after).L.norm(), 10.0);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  const Drift drift = DriftOf(animation, motion);
  EXPECT_GT(drift.turned, 2.0);
  Worst com("com"), L("angular momentum"), energy("energy");
  EXPECT_LE(com(drift.com), 1e-9);
  EXPECT_LE(L(drift.L), 1e-9);
  EXPECT_LE(energy(drift.energy), 1e-8);
  // Finer steps do not help against rounding, so the estimate is four times the distance.
  EXPECT_LE(motion.regions[0].error_estimate, 8.0 * animation.solver.tolerance);
}

// Fast arms without friction or limits: the motion forgets where it began within 2 s.
TEST(FlightBake, OfAChaoticMotionKeepsThemTooAndSaysThatItsAnglesAreNotToBeTrusted) {
  const Animation animation = Thrown(1.0, 1.0);
  const Motion motion = BakeOrFail(animation);
  const Drift drift = DriftOf(animation, motion);
  EXPECT_LE(drift.com, 1e-9);
  EXPECT_LE(drift.L, 1e-9);
  EXPECT_LE(drift.energy, 1e-8);
  EXPECT_GT(motion.regions[0].error_estimate, 1e3 * animation.solver.tolerance);
}

TEST(FlightBake, FrictionInTheArmsTakesEnergyButNoMomentum) {
  const Animation animation = Thrown(0.9, 1.0);
  const Motion motion = BakeOrFail(animation);
  const Drift drift = DriftOf(animation, motion);
  Worst com("com"), L("angular momentum");
  EXPECT_LE(com(drift.com), 1e-9);
  EXPECT_LE(L(drift.L), 1e-9);
  EXPECT_GT(drift.energy, 0.01);
}

TEST(FlightBake, UnequalFrictionTakesNoMomentumEither) {
  Animation animation = Thrown(0.9, 1.0);
  for (size_t i = 0; i < animation.regions[0].friction.size(); ++i) {
    animation.regions[0].friction[i] = i % 3 == 0 ? 0.6 : 0.95;
  }
  const Drift drift = DriftOf(animation, BakeOrFail(animation));
  Worst com("com"), L("angular momentum");
  EXPECT_LE(com(drift.com), 1e-9);
  EXPECT_LE(L(drift.L), 1e-9);
}

// The pin's force does no work and has no moment about the vertical through the pin.
TEST(PinnedBake, HangingByAHandKeepsEnergyAndTheMomentumAboutTheVertical) {
  Animation animation = Swinging(1.0, 0.3);
  AddPin(&animation, 0, kLast, "r_wrist");
  const Motion motion = BakeOrFail(animation);
  const Vec3 pin = OriginOf(animation, motion.frames[0], "r_wrist");
  const Momentum start = MomentumOf(*animation.figure, motion.frames[0].after);
  const auto about_pin = [&](const Momentum& m) {
    return (m.L + m.mass * (m.com - pin).cross(m.com_v)).z();
  };
  Worst place("place"), energy("energy"), L("momentum");
  for (const MotionFrame& frame : motion.frames) {
    const Momentum now = MomentumOf(*animation.figure, frame.after);
    EXPECT_LE(place((OriginOf(animation, frame, "r_wrist") - pin).norm()), 1e-12);
    EXPECT_LE(energy(std::abs(EnergyOf(now) - EnergyOf(start)) / start.kinetic), 1e-8)
        << frame.frame;
    EXPECT_LE(L(std::abs(about_pin(now) - about_pin(start)) / std::abs(about_pin(start))), 1e-9)
        << frame.frame;
  }
  EXPECT_GT((motion.frames[kLast].X_WR.p - motion.frames[0].X_WR.p).norm(), 0.1);
}

// Like a limb that is let go, the root goes on as its keys before the region had it go.
TEST(FlightBake, ARootStartsWithTheSpeedThatItsKeysBuiltUp) {
  Animation animation = Still(LimberHuman());
  animation.last_frame = 20;
  animation.root_keys[kRootZ] = {{0, 5.0, {}, Interpolation::kCubic}};
  animation.root_keys[kRootAngleY] = {{0, 0.0, {}, Interpolation::kCubic},
                                      {10, 1.0, {}, Interpolation::kCubic},
                                      {20, 1.2, {}, Interpolation::kCubic}};
  AddGravity(&animation, 0, 20);
  animation.solver.method = Method::kExact;
  AddRegion(&animation, "tumble", 10, 20, {"r_shoulder"}, 1.0).root = true;
  const Motion motion = Bake(animation).value();
  const double parabola = 2.0 * 1.0 / animation.rate.SecondsAt(10.0);
  EXPECT_NEAR(motion.frames[10].before.root_w.y(), parabola, 1e-9);
  EXPECT_NEAR(motion.frames[10].after.root_w.y(), parabola, 1e-9);
}

}  // namespace
}  // namespace hazumi::test
