// What slides down inclines, and what stays there: for ten seconds, beside the cone of friction.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/compare.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kRunner = 0.02;  // radius of the sledge's capsules [m]

// A box of four capsules along the edges of 0.4 x 0.2 x 0.1 m, which stands on the lower two.
Figure Sledge() {
  FigureSpec spec;
  spec.name = "sledge";
  spec.root_name = "sledge";
  const char* const names[] = {"low_left", "low_right", "high_left", "high_right"};
  for (int i = 0; i < 4; ++i) {
    const Vec3 middle(0.0, i % 2 == 0 ? 0.1 : -0.1, i < 2 ? -0.05 : 0.05);
    LinkSpec rod = Rod(names[i], middle - 0.2 * Vec3::UnitX(), middle + 0.2 * Vec3::UnitX());
    rod.radius = kRunner;
    spec.root_links.push_back(rod);
  }
  JointSpec tip;
  tip.name = "tip";
  tip.parent = "sledge";
  tip.hinges = {{"", Vec3::UnitY(), 0.0, 0.0, 0.0}};
  spec.joints = {tip};
  return BuildFigure(spec).value();
}

struct Slope {
  Animation animation;
  Vec3 start, down;
};

// On it, its axis along the slope, at rest.
Slope On(Figure figure, double above, double angle, double friction, int frames) {
  Slope slope{Loose(std::move(figure), frames), {}, {}};
  slope.down = AddIncline(&slope.animation, angle, friction);
  slope.animation.root_keys[kRootAngleY] = {{0, angle, 0.0, kHold}};
  slope.start = above * Vec3(std::sin(angle), 0.0, std::cos(angle));
  SetRootAt(&slope.animation, slope.start);
  return slope;
}

double FurthestMoved(const Slope& slope, const Motion& motion) {
  double most = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    most = std::max(most, (frame.X_WR.p - slope.start).norm());
  }
  return most;
}

TEST(Incline, ABoxOfCapsulesSlidesAsAPointDoes) {
  for (const double angle : {0.1, 0.3, 0.5}) {
    for (const double friction : {0.0, 0.2, 0.45}) {
      if (std::tan(angle) < friction) continue;
      const Slope slope = On(Sledge(), 0.05 + kRunner, angle, friction, 60);
      const Motion motion = BakeOrFail(slope.animation);
      const double a = kG * (std::sin(angle) - friction * std::cos(angle));
      Worst off("log10 of the error of the place [m]"), turned("log10 of the turn");
      for (const MotionFrame& frame : motion.frames) {
        const double t = frame.frame / 30.0;
        off((frame.X_WR.p - slope.start - 0.5 * a * t * t * slope.down).norm());
        turned((frame.X_WR.R - motion.frames[0].X_WR.R).norm());
      }
      std::printf("  angle %.1f, friction %.2f: off by %.1g m, turned by %.1g\n", angle, friction,
                  off.value(), turned.value());
      EXPECT_LT(off.value(), 1e-6) << angle << " " << friction;
      EXPECT_LT(turned.value(), 1e-6) << angle << " " << friction;
    }
  }
}

// Less than a hundredth of a millimetre in ten seconds, from far below the cone to 1 % below it.
TEST(Incline, WhatIsBelowTheConeStaysForTenSeconds) {
  for (const double angle : {0.1, 0.3, 0.5}) {
    for (const double above_cone : {1.01, 1.1, 2.0}) {
      const double friction = above_cone * std::tan(angle);
      const Slope capsule = On(FreeCapsule(0.3, 0.1), 0.1, angle, friction, 300);
      const Slope sledge = On(Sledge(), 0.05 + kRunner, angle, friction, 300);
      const double a = FurthestMoved(capsule, BakeOrFail(capsule.animation));
      const double b = FurthestMoved(sledge, BakeOrFail(sledge.animation));
      std::printf("  angle %.1f, friction %.3f: the capsule moves by %.1g m, the box by %.1g m\n",
                  angle, friction, a, b);
      EXPECT_LT(a, 1e-5) << angle << " " << above_cone;
      EXPECT_LT(b, 1e-5) << angle << " " << above_cone;
    }
  }
}

// Across the slope it rolls where friction is at least tan q / (1 + m r^2 / I); with less it
// slides, and friction turns it all the same.
TEST(Incline, ACapsuleAcrossRollsOrSlidesAndTurns) {
  const double angle = 0.5, radius = 0.1;
  for (const double of_least : {0.5, 0.98, 1.02, 2.0}) {
    const Figure figure = FreeCapsule(0.3, radius);
    const double inertia = figure.root_body().I_com(0, 0), square = kMass * radius * radius;
    const double least = std::tan(angle) / (1.0 + square / inertia);
    const double friction = of_least * least;
    Slope slope = On(FreeCapsule(0.3, radius), radius, angle, friction, 30);
    slope.animation.root_keys[kRootAngleY].clear();
    slope.animation.root_keys[kRootAngleZ] = {{0, M_PI / 2.0, 0.0, kHold}};
    const Motion motion = BakeOrFail(slope.animation);
    const bool rolls = of_least > 1.0;
    const double a = rolls ? kG * std::sin(angle) / (1.0 + inertia / square)
                           : kG * (std::sin(angle) - friction * std::cos(angle));
    const double turn =
        rolls ? a / radius : friction * kMass * kG * std::cos(angle) * radius / inertia;
    const MotionLimit& end = motion.frames[30].before;
    std::printf("  friction %.3f: off by %.1g m, turns faster by %.1g rad/s\n", friction,
                (end.X_WR.p - slope.start - 0.5 * a * slope.down).norm(),
                std::abs(end.root_w.norm() - turn));
    EXPECT_LT((end.X_WR.p - slope.start - 0.5 * a * slope.down).norm(), 1e-7) << of_least;
    EXPECT_NEAR(end.root_w.norm(), turn, 1e-6) << of_least;
  }
}

// 1 % above the cone it slides.
TEST(Incline, WhatIsJustAboveTheConeSlides) {
  const double angle = 0.3, friction = 0.99 * std::tan(angle);
  const double a = kG * (std::sin(angle) - friction * std::cos(angle));
  for (const bool is_box : {false, true}) {
    const Slope slope = is_box ? On(Sledge(), 0.05 + kRunner, angle, friction, 60)
                               : On(FreeCapsule(0.3, 0.1), 0.1, angle, friction, 60);
    const Motion motion = BakeOrFail(slope.animation);
    const Vec3 end = slope.start + 2.0 * a * slope.down;
    const double off = (motion.frames[60].X_WR.p - end).norm();
    std::printf("  %s: off by %.1g m\n", is_box ? "box" : "capsule", off);
    EXPECT_LT(off, 1e-5) << is_box;
  }
}

}  // namespace
}  // namespace hazumi::test
