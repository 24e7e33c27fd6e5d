// Forces from outside are nobody's effort: what holds against them is, in closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/figures.h"
#include "tests/unit/analysis/baked_effort.h"
#include "tests/unit/bake/force_cases.h"

namespace hazumi::test {
namespace {

constexpr double kWind = 6.0;  // [m/s], across the rod

// rho C_D d u^2 / 2 along the rod, of which each length has its arm.
TEST(OuterEffort, OfARodThatIsHeldStillInAWindIsTheMomentOfItsDrag) {
  Animation animation = Exact(TurningRod(), 0.0);
  KeysOf(&animation, "pivot") = {{0, 0.0, 0.0, kHold}};
  AddForce(&animation, 0, 20, WindForce{Vec3(3.0, kWind, 0.0), kAir});
  const BakedEffort found = BakeEffort(animation);
  const double drag = 0.5 * kAir * kCrossFlow * kThickness * kWind * kWind;  // [N/m]
  const double tau = -0.5 * drag * kLength * kLength;
  for (const size_t i : {0, 7, 19}) {
    const FrameEffort& frame = found.effort.frames[i];
    EXPECT_NEAR(frame.tau[0], tau, 1e-9 * std::abs(tau)) << i;
    EXPECT_NEAR((frame.from_nowhere.force + drag * kLength * Vec3::UnitY()).norm(), 0.0, 1e-9);
    EXPECT_NEAR((frame.from_nowhere.moment - tau * Vec3::UnitZ()).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(found.effort.frames[20].tau[0], 0.0);
}

// Its own motion is part of the air's.
TEST(OuterEffort, OfARodThatIsTurnedInStillAirGoesWithTheSquareOfItsRate) {
  Animation animation = Exact(TurningRod(), 0.0);
  const double w = 4.0;
  KeysOf(&animation, "pivot") = {{0, 0.0, w, kCubic}, {30, w, w, kCubic}};
  AddForce(&animation, 0, 30, WindForce{Vec3::Zero(), kAir});
  const BakedEffort found = BakeEffort(animation);
  const double tau = kAir * kCrossFlow * kThickness * std::pow(kLength, 4) * w * w / 8.0;
  for (const FrameEffort& frame : found.effort.frames) {
    EXPECT_NEAR(frame.tau[0], tau, 1e-9 * tau);
  }
}

TEST(OuterEffort, OfAPullOnARodIsItsMoment) {
  Animation animation = Exact(TurningRod(), 0.0);
  KeysOf(&animation, "pivot") = {{0, 0.0, 0.0, kHold}};
  AttractForce pull;
  pull.at = {GroupIndex(0), Vec3(kLength, 0.0, 0.0)};
  pull.to = {kLength, -2.0, 0.0};
  pull.force = 8.0;
  pull.radius = 0.5;
  AddForce(&animation, 0, 30, pull);
  const BakedEffort found = BakeEffort(animation);
  EXPECT_NEAR(found.effort.frames[5].tau[0], pull.force * kLength, 1e-9);
}

// Arms that hang loose in a wind that carries them along, on a body that is held.
TEST(OuterEffort, OfALimpArmInAWindIsNone) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder", "r_elbow", "r_wrist"}).method = Method::kExact;
  Animation still = animation;
  AddForce(&animation, 0, 30, WindForce{Vec3(9.0, 4.0, 0.0), kAir});
  AttractForce pull;
  pull.at.joint = GroupOf(animation, "r_wrist");
  pull.to = {1.0, 0.5, 2.0};
  pull.force = 5.0;
  AddForce(&animation, 0, 30, pull);
  const BakedEffort found = BakeEffort(animation);
  const BakedEffort calm = BakeEffort(still);
  int swinging = 0;
  for (size_t i = 0; i < found.motion.frames.size(); ++i) {
    const MotionFrame& frame = found.motion.frames[i];
    for (int j = 0; j < frame.q.size(); ++j) {
      if (!frame.in_region[static_cast<size_t>(j)]) continue;
      ++swinging;
      EXPECT_NEAR(found.effort.frames[i].tau[j], 0.0, 1e-6) << i << " " << j;
    }
  }
  EXPECT_GT(swinging, 100);
  EXPECT_GT((found.motion.frames[29].q - calm.motion.frames[29].q).norm(), 0.01);
}

// A figure in flight is carried off, and nothing comes from nowhere.
TEST(OuterEffort, OfAFlightInAWindNeedsNoForceFromNowhere) {
  Animation animation = Flying(FreeRod(), kG);
  animation.root_keys[kRootZ] = {{0, 30.0, 0.0, kHold}};
  AddForce(&animation, 0, 30, WindForce{Vec3(0.0, 8.0, 1.0), kAir});
  const BakedEffort found = BakeEffort(animation);
  for (const FrameEffort& frame : found.effort.frames) {
    EXPECT_LT(frame.from_nowhere.force.norm(), 1e-6);
    EXPECT_LT(frame.from_nowhere.moment.norm(), 1e-6);
  }
  EXPECT_GT(found.motion.frames.back().after.root_v.y(), 0.1);
}

}  // namespace
}  // namespace hazumi::test
