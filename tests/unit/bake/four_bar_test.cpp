// Four bars that a point constraint closes to a loop: on a base and free in flight.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/compare.h"
#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/loops.h"

namespace hazumi::test {
namespace {

struct Kept {
  double gap = 0.0, energy = 0.0;  // the largest, of all frames [m, J]
};

Kept Measure(const Animation& animation, const Motion& motion) {
  const auto energy = [&](const MotionFrame& frame) {
    const Momentum momentum = MomentumOf(*animation.figure, frame.after);
    return momentum.kinetic + momentum.potential(animation.gravity);
  };
  Kept kept;
  for (const MotionFrame& frame : motion.frames) {
    kept.gap = std::max(kept.gap, GapAt(animation, animation.constraints[0], frame));
    kept.energy = std::max(kept.energy, std::abs(energy(frame) - energy(motion.frames[0])));
  }
  return kept;
}

TEST(FourBar, OnABaseStaysClosedAndKeepsItsEnergyForTenSeconds) {
  const Animation animation = FourBar(300);
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  const Kept kept = Measure(animation, motion);
  std::printf("  gap %.1g m, energy %.1g J\n", kept.gap, kept.energy);
  EXPECT_LT(kept.gap, 1e-7);
  EXPECT_LT(kept.energy, 1e-7);
}

// No bar is held: nothing outside takes momentum.
void ExpectKeptInFlight(double tilt) {
  const Animation animation = FreeFourBar(300, tilt);
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(EventsOf(motion, EventKind::kLimit).empty());
  const Kept kept = Measure(animation, motion);
  const Momentum start = MomentumOf(*animation.figure, motion.frames[0].after);
  Worst turn("momentum_log10"), place("place_log10_m");
  double furthest = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    const Momentum now = MomentumOf(*animation.figure, frame.after);
    turn((now.L - start.L).norm() / start.L.norm());
    place((now.com - start.com - t * start.com_v + 0.5 * kG * t * t * Vec3::UnitZ()).norm());
    furthest = std::max(furthest, (frame.q - motion.frames[0].q).lpNorm<Eigen::Infinity>());
  }
  std::printf("  gap %.1g m, energy %.1g J, angular momentum %.1g of it, centre of mass %.1g m\n",
              kept.gap, kept.energy, turn.value(), place.value());
  EXPECT_LT(kept.gap, 1e-7);
  EXPECT_LT(kept.energy, 1e-7);
  EXPECT_LT(turn.value(), 1e-7);
  EXPECT_LT(place.value(), 1e-7);
  EXPECT_GT(furthest, 0.5);  // its bars turn against each other
}

TEST(FourBar, InFlightStaysClosedAndKeepsEnergyAndMomentumForTenSeconds) {
  ExpectKeptInFlight(0.0);
}

// Its hinges alone keep it plane: across that, what closes it has nothing to hold.
TEST(FourBar, InFlightAboutAnyAxisDoesSoToo) { ExpectKeptInFlight(0.1); }

}  // namespace
}  // namespace hazumi::test
