// Links that stay out of each other: beside statics, what a body in flight keeps, and their depth.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/bake/walk/own_pairs.h"
#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

constexpr double kRadius = 0.5 * kThickness;

JointSpec Hinged(const char* name, const char* parent, const Vec3& offset, const Vec3& axis,
                 const LinkSpec& link) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = offset;
  joint.hinges = {{"", axis, -1e3, 1e3, 0.0}};
  joint.links = {link};
  return joint;
}

// A rail across on a crank, below an arm along x that falls onto it; both on a base that stays.
constexpr double kAhead = 0.3, kBelow = 0.1, kCrank = 0.2;  // of the rail's axis [m]
Animation ArmAboveRail() {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.1 * Vec3::UnitZ())};
  const Vec3 half = 0.3 * Vec3::UnitY(), out = kCrank * Vec3::UnitX();
  spec.joints = {Hinged("crank", "base", Vec3(kAhead - kCrank, 0.0, -kBelow), Vec3::UnitY(),
                        Rod("rail", out - half, out + half)),
                 Hinged("arm", "base", Vec3::Zero(), Vec3::UnitY(),
                        Rod("arm", Vec3::Zero(), kLength * Vec3::UnitX()))};
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  DynamicsRegion& region = AddRegion(&animation, "arm", 0, 30, {"arm"});
  region.method = Method::kExact;
  region.touches_self = true;
  KeysOf(&animation, "arm") = {{0, -0.5, 0.0, kHold}};
  return animation;
}

double DeepestOf(const Animation& animation, const Motion& motion) {
  const Figure& figure = *animation.figure;
  const std::vector<LinkPair> pairs = PairsApart(figure);
  DynamicsWorkspace ws(figure);
  double depth = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    const std::optional<Overlap> deepest = DeepestOverlap(pairs, figure, ws);
    depth = std::max(depth, deepest ? deepest->depth : 0.0);
  }
  return depth;
}

// Where its axis is twice the radius from the rail's, with what holds its weight.
TEST(SelfContact, AnArmComesToRestOnARail) {
  const Animation animation = ArmAboveRail();
  const Motion motion = BakeOrFail(animation);
  EXPECT_LT(DeepestOf(animation, motion), 1e-8);
  const MotionFrame& last = motion.frames.back();
  const double angle =
      std::atan2(kBelow, kAhead) - std::asin(2.0 * kRadius / std::hypot(kAhead, kBelow));
  const int arm = animation.figure->FindJoint("arm")->value();
  EXPECT_NEAR(last.q[arm], angle, 1e-8);
  EXPECT_NEAR(last.after.qd[arm], 0.0, 1e-12);
  ASSERT_EQ(last.contacts.pushes.size(), 2u);
  const ContactPush &on_arm = last.contacts.pushes[0], &on_rail = last.contacts.pushes[1];
  EXPECT_EQ(animation.figure->links()[on_arm.link].name, "arm");
  EXPECT_EQ(animation.figure->links()[on_arm.by_link].name, "rail");
  EXPECT_EQ(on_rail.link, on_arm.by_link);
  EXPECT_EQ(on_rail.by_link, on_arm.link);
  EXPECT_EQ(on_arm.object, -1);
  EXPECT_EQ(on_rail.p, on_arm.p);
  EXPECT_EQ(on_rail.force, -on_arm.force);
  const double weighs = kMass * kG * 0.5 * kLength * std::cos(angle);  // about the hinge
  EXPECT_NEAR((on_arm.p - last.X_WR.p).cross(on_arm.force).y(), -weighs, 1e-8);
}

TEST(SelfContact, WithoutItTheArmFallsThrough) {
  Animation animation = ArmAboveRail();
  animation.regions[0].touches_self = false;
  const Motion motion = BakeOrFail(animation);
  EXPECT_GT(DeepestOf(animation, motion), 0.5 * kRadius);
  for (const MotionFrame& frame : motion.frames) EXPECT_TRUE(frame.contacts.pushes.empty());
}

// A rail that keys turn upwards takes the arm along, and its work is the keys'.
TEST(SelfContact, AKeyedRailLiftsTheArm) {
  Animation animation = ArmAboveRail();
  KeysOf(&animation, "crank") = {{0, 0.0, 0.0}, {15, 0.0, 0.0}, {30, -0.8, 0.0}};
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_LT(DeepestOf(animation, motion), 1e-8);
  const int arm = animation.figure->FindJoint("arm")->value();
  EXPECT_LT(motion.frames[28].q[arm], motion.frames[15].q[arm] - 0.1);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_LT(energy.WorkOf("contact"), -0.1);
  EXPECT_GT(energy.keyed, 0.5);
  EXPECT_NEAR(energy.residual(), 0.0, 1e-7 * energy.keyed);
}

// A chain in flight that curls up, out of its plane too, all of whose joints begin at `angle`.
Animation CurlingChain(double angle) {
  FigureSpec spec;
  spec.name = "chain";
  spec.root_name = "base";
  const Vec3 along = 0.4 * Vec3::UnitX();
  spec.root_links = {Rod("base", -along, Vec3::Zero())};
  const char* const names[] = {"one", "two", "three", "four"};
  for (int i = 0; i < 4; ++i) {
    const Vec3 offset = i == 0 ? Vec3(Vec3::Zero()) : along;
    const Vec3 axis = i == 2 ? Vec3(0.05, 1.0, 0.05).normalized() : Vec3(Vec3::UnitY());
    spec.joints.push_back(Hinged(names[i], i == 0 ? "base" : names[i - 1], offset, axis,
                                 Rod(names[i], Vec3::Zero(), along)));
  }
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  AddGravity(&animation, 0, 30);
  FreeAll(&animation, {"one"});
  animation.regions[0].touches_self = true;
  for (const char* name : names) KeysOf(&animation, name) = {{0, angle, 4.0, kHold}};
  return animation;
}

void ExpectFlight(const Animation& animation, const Motion& motion) {
  const Momentum first = MomentumOf(*animation.figure, motion.frames.front().after);
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0;
    const Momentum now = MomentumOf(*animation.figure, frame.after);
    EXPECT_LT((now.L - first.L).norm(), 1e-6 * first.L.norm()) << frame.frame;
    const Vec3 com = first.com + t * first.com_v - 0.5 * kG * t * t * Vec3::UnitZ();
    EXPECT_LT((now.com - com).norm(), 1e-6) << frame.frame;
  }
}

TEST(SelfContact, WhatABodyInFlightKeepsIsKept) {
  const Animation animation = CurlingChain(1.2);
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_LT(DeepestOf(animation, motion), 1e-4);
  ExpectFlight(animation, motion);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_LT(energy.impacts, -0.05 * energy.kinetic_start);  // loss by impacts
  EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * energy.kinetic_start);
  // Begins inside itself, so that forces are frozen.
  const Animation curled = CurlingChain(1.5);
  const Motion frozen = BakeOrFail(curled);
  EXPECT_TRUE(frozen.regions[0].estimated_until.has_value());
  ExpectFlight(curled, frozen);
}

// Two arms on one body, each a region of its own, that swing into each other.
TEST(SelfContact, RegionsThatMeetAreSolvedAsOne) {
  FigureSpec spec;
  spec.name = "arms";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.1 * Vec3::UnitZ())};
  const Vec3 along = 0.5 * Vec3::UnitX();
  spec.joints = {
      Hinged("l", "base", 0.1 * Vec3::UnitY(), Vec3::UnitZ(), Rod("l", Vec3::Zero(), along)),
      Hinged("r", "base", -0.1 * Vec3::UnitY(), Vec3::UnitZ(), Rod("r", Vec3::Zero(), along))};
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  for (const char* name : {"l", "r"}) {
    const double sign = name[0] == 'l' ? -1.0 : 1.0;
    KeysOf(&animation, name) = {{0, 0.0, sign, kHold}};
    DynamicsRegion& region = AddRegion(&animation, name, 0, 30, {name});
    region.method = Method::kExact;
    region.touches_self = name[0] == 'l';
  }
  const Motion motion = BakeOrFail(animation);
  EXPECT_LT(DeepestOf(animation, motion), 1e-8);
  // Their ends meet halfway, and stop each other there.
  const double angle = std::asin((0.1 - kRadius) / 0.5);
  EXPECT_NEAR(motion.frames.back().q[0], -angle, 1e-8);
  EXPECT_NEAR(motion.frames.back().q[1], angle, 1e-8);
}

// What overlaps at the start is said, and leaves slowly.
TEST(SelfContact, WhatBeginsInsideIsToldOfAndComesOut) {
  Animation animation = ArmAboveRail();
  const double rests =
      std::atan2(kBelow, kAhead) - std::asin(2.0 * kRadius / std::hypot(kAhead, kBelow));
  KeysOf(&animation, "arm") = {{0, rests + 0.02, 0.0, kHold}};
  const Motion motion = BakeOrFail(animation);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_EQ(motion.warnings[0].place, "regions[0]");
  EXPECT_NE(motion.warnings[0].message.find("inside each other in frame 0"), std::string::npos)
      << motion.warnings[0].message;
  const int arm = animation.figure->FindJoint("arm")->value();
  double before = motion.frames.front().q[arm];
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_LE(std::abs(frame.after.qd[arm]), 0.12 / kAhead) << frame.frame;
    EXPECT_LE(frame.q[arm], before + 1e-5) << frame.frame;
    before = frame.q[arm];
  }
  EXPECT_NEAR(before, rests, 1e-3);
}

// Where contacts come too fast to be followed as well.
TEST(SelfContact, AHumanWhoFallsStaysOutOfHimself) {
  constexpr double kMostDepth = 5e-4;  // [m]
  for (const double tilt : {-0.7, -0.5, -0.2}) {
    Animation animation = LooseHuman(90, 1.4, tilt);
    const double before = DeepestOf(animation, BakeOrFail(animation));
    animation.regions[0].touches_self = true;
    BakeOptions options;
    options.energy = true;
    const Motion motion = BakeOrFail(animation, options);
    EXPECT_GT(before, 10.0 * kMostDepth) << tilt;
    EXPECT_LT(DeepestOf(animation, motion), kMostDepth) << tilt;
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_GT(ClearanceOf(animation, frame), -kMostDepth) << tilt << " " << frame.frame;
    }
    const EnergyBalance& energy = motion.regions[0].energy.value();
    EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * std::abs(energy.potential_start)) << tilt;
    EXPECT_LT(energy.WorkOf("contact") + energy.impacts + energy.limits, 0.0) << tilt;
  }
}

TEST(PairsApart, LeavesOutNeighboursAndWhatOverlapsAtRest) {
  const Figure figure = LimberHuman();
  const auto has = [&](const char* a, const char* b) {
    const auto pairs = PairsApart(figure);
    return std::any_of(pairs.begin(), pairs.end(), [&](const LinkPair& pair) {
      const std::string &one = figure.links()[pair.a].name, &two = figure.links()[pair.b].name;
      return (one == a && two == b) || (one == b && two == a);
    });
  };
  EXPECT_TRUE(has("l_forearm", "r_forearm"));
  EXPECT_TRUE(has("l_thigh", "r_shank"));
  EXPECT_FALSE(has("l_upper_arm", "l_forearm"));
  EXPECT_FALSE(has("l_thigh", "l_shank"));
}

}  // namespace
}  // namespace hazumi::test
