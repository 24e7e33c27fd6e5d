// What touches planes and boxes, beside closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

TEST(ContactBake, ABallDropsAndLiesStill) {
  Animation animation = Loose(FreeCapsule(0.0, kBallRadius), 60);
  AddFloor(&animation);
  SetRootAt(&animation, Vec3(0.0, 0.0, 1.0));
  const Motion motion = BakeOrFail(animation);
  const double t_hit = std::sqrt(2.0 * (1.0 - kBallRadius) / kG);
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    const double z = t < t_hit ? 1.0 - 0.5 * kG * t * t : kBallRadius;
    EXPECT_NEAR(frame.X_WR.p.z(), z, 1e-8) << frame.frame;
  }
}

TEST(ContactBake, ACapsuleSlidesDownAnInclineOrSticks) {
  for (const double angle : {0.1, 0.3, 0.5}) {
    for (const double friction : {0.0, 0.2, 0.45}) {
      Animation animation = Loose(FreeCapsule(0.3, 0.1), 60);
      const Vec3 down = AddIncline(&animation, angle, friction);
      animation.root_keys[kRootAngleY] = {{0, angle, 0.0, kHold}};  // along the slope
      const Vec3 start = 0.1 * Vec3(std::sin(angle), 0.0, std::cos(angle));
      SetRootAt(&animation, start);
      const Motion motion = BakeOrFail(animation);
      const double a = std::max(0.0, kG * (std::sin(angle) - friction * std::cos(angle)));
      for (const MotionFrame& frame : motion.frames) {
        const double t = frame.frame / 30.0;
        EXPECT_LT((frame.X_WR.p - start - 0.5 * a * t * t * down).norm(), 1e-7)
            << angle << " " << friction << " " << frame.frame;
      }
    }
  }
}

TEST(ContactBake, ACapsuleRollsDownAnIncline) {
  const Figure figure = FreeCapsule(0.3, 0.1);
  const double angle = 0.3;
  Animation animation = Loose(FreeCapsule(0.3, 0.1), 60);
  const Vec3 down = AddIncline(&animation, angle, 0.8);
  animation.root_keys[kRootAngleZ] = {{0, M_PI / 2.0, 0.0, kHold}};  // across the slope
  const Vec3 start = 0.1 * Vec3(std::sin(angle), 0.0, std::cos(angle));
  SetRootAt(&animation, start);
  const Motion motion = BakeOrFail(animation);
  const double inertia = figure.root_body().I_com(0, 0);
  const double a = kG * std::sin(angle) / (1.0 + inertia / (kMass * 0.01));
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    EXPECT_LT((frame.X_WR.p - start - 0.5 * a * t * t * down).norm(), 1e-7) << frame.frame;
  }
}

// Below the end of a tilted rod, without friction: w^2 = 12 g (cos q0 - cos q) / (L (1 + 3 sin^2
// q)) of a thin one that falls from q0; of one with the inertia I about its middle, at height h = L
// / 2 of that above its end, w^2 = 2 m g h (cos q0 - cos q) / (I + m h^2 sin^2 q).
TEST(ContactBake, ARodOnSmoothGroundFallsByTheLaw) {
  const double half = 0.4, radius = 0.02, q0 = 0.4;
  Animation animation = Loose(FreeCapsule(half, radius), 15);
  AddIncline(&animation, 0.0, 0.0);
  animation.root_keys[kRootAngleY] = {{0, M_PI / 2.0 - q0, 0.0, kHold}};
  SetRootAt(&animation, Vec3(0.0, 0.0, radius + half * std::cos(q0)));
  const Motion motion = BakeOrFail(animation);
  const double I = animation.figure->root_body().I_com(1, 1);
  int falling = 0;
  for (const MotionFrame& frame : motion.frames) {
    const double cosine = std::abs(frame.X_WR.R(2, 0));
    if (cosine < 0.05) break;  // it is about to lie
    const double sine = std::sqrt(1.0 - cosine * cosine), h = half;
    const double w = std::sqrt(2.0 * kMass * kG * h * (std::cos(q0) - cosine) /
                               (I + kMass * h * h * sine * sine));
    EXPECT_NEAR(frame.after.root_w.norm(), w, 1e-6) << frame.frame;
    EXPECT_NEAR(frame.X_WR.p.x(), 0.0, 1e-9);
    ++falling;
  }
  EXPECT_GT(falling, 8);
}

// Nothing goes in deeper than 0.1 mm, and no energy comes from nowhere.
TEST(ContactBake, AChainFallsAndLiesStill) {
  Animation animation = Loose(*Chain().figure, 120, {"one"});
  animation.solver.tolerance = 1e-3 * kDegree;
  animation.regions[0].friction.assign(animation.regions[0].joints.size(), 0.8);
  AddFloor(&animation);
  SetRootAt(&animation, Vec3(0.0, 0.0, 0.8));
  const Motion motion = BakeOrFail(animation);
  double most = 0.0, energy = EnergyOf(animation, motion.frames.front().after);
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_GT(ClearanceOf(animation, frame), -1e-4) << frame.frame;
    const double now = EnergyOf(animation, frame.after);
    EXPECT_LT(now, energy + 1e-6 * kMass * kG) << frame.frame;
    energy = now;
    most = std::max(most, MomentumOf(*animation.figure, frame.after).kinetic);
  }
  EXPECT_LT(MomentumOf(*animation.figure, motion.frames.back().after).kinetic, 1e-6 * most);
}

// However often it is looked at, and whatever is asked there: the same bits.
TEST(ContactBake, ToBeLookedAtChangesNothing) {
  Animation animation = Loose(*Chain().figure, 90, {"one"});
  animation.regions[0].friction.assign(animation.regions[0].joints.size(), 0.8);
  AddFloor(&animation);
  SetRootAt(&animation, Vec3(0.0, 0.0, 0.8));
  const Motion motion = BakeOrFail(animation);
  BakeOptions more;
  more.accelerations = true;
  more.output_rate = FrameRate{90, 1};
  const Motion looked_at = BakeOrFail(animation, more);
  for (size_t i = 0; i < motion.frames.size(); ++i) {
    EXPECT_EQ(motion.frames[i].q, looked_at.frames[3 * i].q) << i;
    EXPECT_EQ(motion.frames[i].X_WR.p, looked_at.frames[3 * i].X_WR.p) << i;
    EXPECT_EQ(motion.frames[i].contacts, looked_at.frames[3 * i].contacts) << i;
  }
}

}  // namespace
}  // namespace hazumi::test
