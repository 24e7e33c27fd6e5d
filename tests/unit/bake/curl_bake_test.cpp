// A forearm that lifts a weight with all the strength of its elbow, beside the heaviest weight that
// it can hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/analysis/effort.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"

namespace hazumi::test {
namespace {

constexpr double kUpperArm = 0.2751, kForearm = 1.5, kForearmCentre = 0.15,
                 kGrip = 0.35;  // [m, kg]
constexpr double kCurlFrom = 40.0 * kDegree, kCurlTo = 125.0 * kDegree;

// Muscles of the shipped human's elbow.
JointStrength ElbowStrength() {
  const Figure human =
      BuildFigure(LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value()).value();
  return *human.joint(*human.FindJoint("r_elbow_flexion")).strength;
}

// An upper arm that hangs down and a forearm: angles lift forwards.
Figure CurlingArm() {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  JointSpec shoulder, elbow;
  shoulder.name = "shoulder";
  shoulder.parent = "base";
  shoulder.hinges = {{"", -Vec3::UnitY(), -2.0, 2.0, 0.0}};
  LinkSpec link;
  link.name = "upper arm";
  link.to = -kUpperArm * Vec3::UnitZ();
  link.radius = 0.04;
  link.mass = 1.9;
  shoulder.links = {link};
  elbow.name = "elbow";
  elbow.parent = "shoulder";
  elbow.offset = link.to;
  elbow.hinges = {{"", -Vec3::UnitY(), 0.0, 150.0 * kDegree, 0.0, ElbowStrength()}};
  link.name = "forearm";
  link.to = -2.0 * kForearmCentre * Vec3::UnitZ();
  link.mass = kForearm;
  elbow.links = {link};
  spec.joints = {shoulder, elbow};
  return BuildFigure(spec).value();
}

// What it can hold still at all angles of the way [kg], and at which it can hold no more [rad].
struct Heaviest {
  double mass = HUGE_VAL, angle = 0.0;
};
Heaviest HeaviestHeld() {
  const JointStrength strength = ElbowStrength();
  Heaviest heaviest;
  for (double angle = kCurlFrom; angle <= kCurlTo; angle += 1e-4) {
    const double moment = strength.At(angle, 0.0).positive.torque / (kG * std::sin(angle));
    const double mass = (moment - kForearm * kForearmCentre) / kGrip;
    if (mass < heaviest.mass) heaviest = {mass, angle};
  }
  return heaviest;
}

Animation Curl(double mass, int frames) {
  Animation animation = Still(CurlingArm());
  animation.last_frame = frames;
  animation.solver.method = Method::kExact;
  animation.solver.tolerance = 1e-7 * kDegree;
  KeysOf(&animation, "elbow") = {{0, kCurlFrom, 0.0, Interpolation::kHold},
                                 {1, kCurlTo, 0.0, Interpolation::kHold}};
  HeldObject weight;
  weight.name = "weight";
  weight.shape = SphereShape{0.05};
  weight.mass = mass;
  weight.holders = {
      {GroupOf(animation, "elbow"), -kGrip * Vec3::UnitZ(), Holder::kFromTheStart, {}}};
  animation.held_objects = {weight};
  DynamicsRegion& region = AddRegion(&animation, "curl", 0, frames, {"elbow"});
  region.method = Method::kExact;
  Drive drive;
  drive.kind = DriveKind::kSpring;
  drive.joints = region.joints;
  drive.frequency = 5.0;
  drive.damping_ratio = 1.0;
  drive.strength = 1.0;
  region.drives = {drive};
  return animation;
}

struct Curled {
  Motion motion;
  Effort effort;
};
Curled EffortOfCurl(const Animation& animation, FrameRate rate) {
  BakeOptions options;
  options.accelerations = true;
  options.output_rate = rate;
  Curled curled{BakeOrFail(animation, options), {}};
  curled.effort = EffortOf(animation, curled.motion);
  return curled;
}

TEST(CurlBake, OnePerCentLessThanTheHeaviestGetsUpAndOneMoreDoesNot) {
  const Heaviest heaviest = HeaviestHeld();
  const Animation light = Curl(0.99 * heaviest.mass, 450), heavy = Curl(1.01 * heaviest.mass, 450);
  const Curled up = EffortOfCurl(light, {30, 1}), stuck = EffortOfCurl(heavy, {30, 1});
  double highest = 0.0;
  for (const MotionFrame& frame : stuck.motion.frames) highest = std::max(highest, frame.q[1]);
  const double end = up.motion.frames.back().q[1];
  std::printf(
      "  the heaviest: %.3f kg, at %.1f degrees; 1 %% less gets to %.1f, 1 %% more to %.1f "
      "degrees\n",
      heaviest.mass, heaviest.angle / kDegree, end / kDegree, highest / kDegree);
  EXPECT_GT(end, kCurlTo - 3.0 * kDegree);
  EXPECT_LT(highest, heaviest.angle);
  // Who is at the end of its strength is told.
  EXPECT_TRUE(up.motion.warnings.empty());
  ASSERT_EQ(stuck.motion.warnings.size(), 1u);
  EXPECT_EQ(stuck.motion.warnings[0].place, "regions[0].drives");
  EXPECT_TRUE(stuck.motion.warnings[0].message.starts_with(
      "the spring of \"elbow\" is too weak: in frame 450 it gives all it can, "))
      << stuck.motion.warnings[0].message;
  const auto lines = BriefEffortReport(heavy, stuck.motion, stuck.effort);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].starts_with("largest effort: elbow 100 % of its strength")) << lines[0];
}

// However closely it is looked at, while it pulls all it can, lets go and brakes.
TEST(CurlBake, TheElbowNeverGivesMoreThanItsStrength) {
  const Animation animation = Curl(0.6 * HeaviestHeld().mass, 30);
  const Curled curled = EffortOfCurl(animation, {30000, 1});
  double most = 0.0, least_torque = 0.0;
  int saturated = 0;
  for (size_t i = 0; i + 1 < curled.motion.frames.size(); ++i) {
    const MotionLimit& at = curled.motion.frames[i].after;
    const double torque = curled.effort.frames[i].tau[1];
    const StrengthLimits limits =
        animation.figure->joint(JointIndex(1)).strength->At(at.q[1], at.qd[1]);
    const double share = torque / (torque > 0.0 ? limits.positive.torque : limits.negative.torque);
    most = std::max(most, std::abs(share));
    least_torque = std::min(least_torque, torque);
    saturated += std::abs(share) > 1.0 - 1e-6;
  }
  std::printf("  at most %.12f of its strength, all of it in %d of 30000 looks, least %.1f N m\n",
              most, saturated, least_torque);
  EXPECT_LT(most, 1.0 + 1e-8);
  EXPECT_GT(saturated, 3000);
  EXPECT_LT(saturated, 27000);
}

}  // namespace
}  // namespace hazumi::test
