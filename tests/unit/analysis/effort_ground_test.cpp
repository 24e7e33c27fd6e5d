// Contact forces of soles and hands, and residual wrenches that no contact can supply.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/analysis/missing_support.h"
#include "engine/analysis/problems/problems.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/support/figures.h"
#include "tests/unit/analysis/baked_effort.h"

namespace hazumi::test {
namespace {

Animation Jump() {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/jump.kfa";
  return CompileAnimation(LoadProject(path).value()).value().animation;
}

void ExpectInCones(const FrameEffort& frame) {
  for (const EffortContact& contact : frame.contacts) {
    EXPECT_FALSE(contact.is_grip);
    const double most = kGroundFriction * contact.force.z() * (1.0 + 1e-9) + 1e-9;
    EXPECT_LE(contact.force.head<2>().norm(), most);
  }
}

TEST(GroundEffort, SymmetricCrouchWithOnePinnedFoot_HasEqualEffortOnBothSides) {
  const Animation animation = Jump();
  const BakedEffort found = BakeEffort(animation);
  for (const size_t i : {0, 1, 2, 3}) {
    const FrameEffort& frame = found.effort.frames[i];
    ASSERT_TRUE(found.motion.frames[i].pinned) << i;
    for (const EffortContact& contact : frame.contacts) {
      EXPECT_FALSE(contact.is_grip) << i;
      EXPECT_GE(contact.force.z(), 0.0) << i;
    }
    for (const char* hinge : {"ankle_flexion", "knee", "hip_flexion"}) {
      const int right = JointOf(animation, (std::string("r_") + hinge).c_str()).value();
      const int left = JointOf(animation, (std::string("l_") + hinge).c_str()).value();
      EXPECT_NEAR(frame.tau[right], frame.tau[left], 1e-4) << i << " " << hinge;
    }
  }
}

TEST(GroundEffort, Flight_HasNoContacts) {
  const Animation animation = Jump();
  const BakedEffort found = BakeEffort(animation, FrameRate{240, 1});
  const double take_off = EventsOf(found.motion, EventKind::kTakeOff).at(0).time;
  const double landing = EventsOf(found.motion, EventKind::kLanding).at(0).time;
  int flying = 0;
  for (size_t i = 0; i < found.motion.frames.size(); ++i) {
    const double t = found.motion.rate.SecondsAt(found.motion.frames[i].frame);
    if (t <= take_off || t >= landing) continue;
    ++flying;
    EXPECT_TRUE(found.effort.frames[i].contacts.empty()) << t;
    EXPECT_LT(found.effort.frames[i].from_nowhere.force.norm(), 1e-6) << t;
  }
  EXPECT_GT(flying, 40);
}

// Flight by keys alone, without a placement by gravity.
TEST(GroundEffort, FigureAboveTheGround_HasNoContacts) {
  Animation animation = Standing();
  animation.root_keys[kRootZ] = {{0, kHipHeight, 0.0, kCubic},
                                 {10, kHipHeight + 0.3, {}, kCubic},
                                 {20, kHipHeight, 0.0, kCubic}};
  const BakedEffort found = BakeEffort(animation, FrameRate{240, 1});
  int above = 0;
  for (size_t i = 0; i < found.motion.frames.size(); ++i) {
    if (found.motion.frames[i].X_WR.p.z() < kHipHeight + 0.0101) continue;
    ++above;
    EXPECT_TRUE(found.effort.frames[i].contacts.empty()) << i;
  }
  EXPECT_GT(above, 80);
}

// Distance of the centre of mass in front of all contact points [m].
double BeyondToes(const MotionFrame& frame, const FrameEffort& effort) {
  double toes = -1e300;
  for (const EffortContact& contact : effort.contacts) toes = std::max(toes, contact.p.x());
  return frame.com.x() - toes;
}

// Figure with flat soles whose legs and trunk lean forward from the ankles.
Animation Leaning(double lean, bool is_pinned) {
  Animation animation = Standing();
  const auto ankle_height = [&] {
    return OriginOf(animation, BakeOrFail(animation).frames[0], "r_ankle").z();
  };
  const double standing = ankle_height();
  for (const char* hinge : {"l_ankle_flexion", "r_ankle_flexion"}) {
    KeysOf(&animation, hinge) = {{0, lean, 0.0, kCubic}};
  }
  animation.root_keys[kRootAngleY] = {{0, lean, 0.0, kCubic}};
  animation.root_keys[kRootZ] = {{0, kHipHeight + standing - ankle_height(), 0.0, kCubic}};
  if (is_pinned) AddPin(&animation, 0, 30, "r_ankle");
  return animation;
}

class LeaningEffort : public ::testing::TestWithParam<bool> {};

TEST_P(LeaningEffort, Toes_CarryTheWeightAndLeaveAResidualMoment) {
  const Animation animation = Leaning(0.24, GetParam());
  const BakedEffort found = BakeEffort(animation);
  const FrameEffort& frame = found.effort.frames[7];
  const double weight = animation.figure->total_mass() * kG;
  const double beyond = BeyondToes(found.motion.frames[7], frame);
  ASSERT_GT(beyond, 0.02);
  ASSERT_LT(beyond, 0.15);
  ExpectInCones(frame);
  EXPECT_LT((SumOfContacts(frame) - weight * Vec3::UnitZ()).norm(), 1e-6 * weight);
  EXPECT_NEAR(LegForce(animation, frame, "l_").z(), 0.5 * weight, 1e-4 * weight);
  const std::vector<MissingSupport> missing =
      MissingSupports(animation, found.motion, found.effort);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].fault, SupportFault::kTips);
  EXPECT_EQ(missing[0].first, 0);
  EXPECT_EQ(missing[0].last, 30);
  EXPECT_NEAR(missing[0].distance, beyond, 1e-4);
  EXPECT_NEAR(missing[0].moment, weight * beyond, 1e-3 * weight * beyond);
}

INSTANTIATE_TEST_SUITE_P(Roots, LeaningEffort, ::testing::Bool());

TEST(MissingSupport, MassOverTheFeet_IsSupported) {
  for (const bool is_pinned : {false, true}) {
    const Animation animation = Leaning(0.02, is_pinned);
    const BakedEffort found = BakeEffort(animation);
    EXPECT_TRUE(MissingSupports(animation, found.motion, found.effort).empty());
    EXPECT_LT(found.effort.frames[5].from_nowhere.moment.norm(), 1e-6);
  }
}

TEST(MissingSupport, Text_StatesTheDistanceAndTheRemedy) {
  const Animation animation = Leaning(0.24, true);
  const BakedEffort found = BakeEffort(animation);
  const std::string text =
      TextOf(MissingSupports(animation, found.motion, found.effort).at(0), animation);
  EXPECT_TRUE(text.starts_with("Frames 0 to 30, most at ")) << text;
  EXPECT_NE(text.find("the centre of mass is "), std::string::npos) << text;
  EXPECT_NE(text.find(" cm beyond "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(" Move the weight back, or step there.")) << text;
}

TEST(MissingSupport, FloatingFigure_LacksItsWeight) {
  Animation animation = Standing();
  animation.root_keys[kRootZ] = {{0, 2.0, 0.0, kCubic}};
  const BakedEffort found = BakeEffort(animation);
  const auto missing = MissingSupports(animation, found.motion, found.effort);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].fault, SupportFault::kFloats);
  EXPECT_NEAR(missing[0].force, animation.figure->total_mass() * kG, 1e-6);
}

// Keys pull the figure down at 3 g, faster than it would fall.
TEST(MissingSupport, DropFasterThanAFall_IsPulled) {
  Animation animation = Standing();
  const double drop = -1.5 * kG * 0.1 * 0.1;
  animation.root_keys[kRootZ] = {{0, kHipHeight, 0.0, kCubic}, {3, kHipHeight + drop, {}, kCubic}};
  const BakedEffort found = BakeEffort(animation, FrameRate{240, 1});
  const auto missing = MissingSupports(animation, found.motion, found.effort);
  ASSERT_FALSE(missing.empty());
  EXPECT_EQ(missing[0].fault, SupportFault::kPulled);
  for (const FrameEffort& frame : found.effort.frames) ExpectInCones(frame);
}

SupportFault WorstFaultOf(const Animation& animation, double friction) {
  BakedEffort found = BakeEffort(animation);
  EffortOptions options;
  options.friction = friction;
  found.effort = EffortOf(animation, found.motion, options);
  const auto missing = MissingSupports(animation, found.motion, found.effort);
  EXPECT_FALSE(missing.empty());
  if (missing.empty()) return SupportFault::kFloats;
  return std::max_element(missing.begin(), missing.end(),
                          [](const auto& a, const auto& b) { return a.moment < b.moment; })
      ->fault;
}

TEST(MissingSupport, SwayOnIce_Slides) {
  Animation animation = Standing();
  animation.root_keys[kRootX] = {{0, 0.0, 0.0, kCubic}, {6, 0.02, 0.0, kCubic}};
  EXPECT_EQ(WorstFaultOf(animation, 0.02), SupportFault::kSlides);
}

// 0.3 g forwards, with the centre of mass over the feet.
TEST(MissingSupport, FastSwayOfAMassOverTheFeet_IsPushedOff) {
  Animation animation = Standing();
  animation.root_keys[kRootX] = {{0, 0.0, 0.0, kCubic}, {6, 0.02, 0.0, kCubic}};
  EXPECT_EQ(WorstFaultOf(animation, kGroundFriction), SupportFault::kPushedOff);
}

TEST(MissingSupport, TwistOnIce_Turns) {
  Animation animation = Standing();
  animation.root_keys[kRootAngleZ] = {{0, 0.0, 0.0, kCubic}, {6, 0.3, 0.0, kCubic}};
  EXPECT_EQ(WorstFaultOf(animation, 0.02), SupportFault::kTurned);
}

TEST(MissingSupport, FlightThatSpinsUp_TurnsInTheAir) {
  Animation animation = Standing();
  animation.root_keys[kRootZ] = {{0, 8.0, 0.0, kCubic}};
  animation.root_keys[kRootAngleY] = {{0, 0.0, 0.0, kCubic}, {15, 1.0, {}, kCubic}};
  AddGravity(&animation, 0, 30);
  EXPECT_EQ(WorstFaultOf(animation, kGroundFriction), SupportFault::kTurnsInAir);
}

// Without weight it stays on the ground while gravity places it.
TEST(GroundEffort, FrameOnWhichAFlightEnds_HasContacts) {
  Animation animation = Standing();
  animation.gravity = 0.0;
  animation.last_frame = 130;
  AddGravity(&animation, 0, 123);
  const BakedEffort found = BakeEffort(animation);
  EXPECT_NE(animation.rate.FrameAt(animation.rate.SecondsAt(123)), 123.0);
  EXPECT_FALSE(found.motion.frames[123].pinned);
  EXPECT_FALSE(found.effort.frames[123].contacts.empty());
}

// Figure that hangs by a hand. Only the hand is near the bar.
Animation Hanging() {
  Animation animation = Still(ShippedHuman());
  KeysOf(&animation, "r_shoulder_flexion") = {{0, 3.0, 0.0, kCubic}};
  animation.root_keys[kRootZ] = {{0, 1.0, 0.0, kCubic}};
  const BakedEffort loose = BakeEffort(animation);
  const Vec3 wrist = OriginOf(animation, loose.motion.frames[0], "r_wrist");
  SceneObject bar;
  bar.name = "bar";
  bar.shape = Capsule{wrist + Vec3(0.0, -0.5, 0.07), wrist + Vec3(0.0, 0.5, 0.07), 0.014};
  animation.scene.push_back(bar);
  return animation;
}

TEST(GripEffort, PinnedHandOnABar_CarriesTheWeight) {
  Animation animation = Hanging();
  AddPin(&animation, 0, 30, "r_wrist");
  const BakedEffort found = BakeEffort(animation);
  const FrameEffort& frame = found.effort.frames[4];
  const double weight = animation.figure->total_mass() * kG;
  ASSERT_EQ(frame.contacts.size(), 1u);
  EXPECT_TRUE(frame.contacts[0].is_grip);
  EXPECT_LT((frame.contacts[0].force - weight * Vec3::UnitZ()).norm(), 1e-6);
  EXPECT_LT(frame.from_nowhere.force.norm(), 1e-6);
}

TEST(GripEffort, HeldHandOnABar_CarriesTheWeight) {
  Animation animation = Hanging();
  AddHold(&animation, 0, 30, "r_wrist", false);
  const BakedEffort found = BakeEffort(animation);
  EXPECT_TRUE(found.effort.frames[4].contacts.at(0).is_grip);
  EXPECT_LT(found.effort.frames[4].from_nowhere.force.norm(), 1e-6);
}

// Hand beside the bar, without a hold.
TEST(GripEffort, FreeHand_DoesNotGrip) {
  const BakedEffort found = BakeEffort(Hanging());
  for (const EffortContact& contact : found.effort.frames[4].contacts) {
    EXPECT_FALSE(contact.is_grip);
  }
  EXPECT_GT(found.effort.frames[4].from_nowhere.force.norm(), 100.0);
}

// Pinned foot in a scene without ground. The foot supports the figure and cannot pull.
TEST(PinnedEffort, PinnedFootWithoutAGround_CarriesAsOnTheGround) {
  Animation animation = Leaning(0.24, true);
  const BakedEffort on_ground = BakeEffort(animation);
  animation.scene.clear();
  const BakedEffort without = BakeEffort(animation);
  const FrameEffort& frame = without.effort.frames[3];
  ExpectInCones(frame);
  const double weight = animation.figure->total_mass() * kG;
  EXPECT_LT((SumOfContacts(frame) - weight * Vec3::UnitZ()).norm(), 1e-6 * weight);
  EXPECT_EQ(LegForce(animation, frame, "l_").norm(), 0.0);
  EXPECT_GT(on_ground.effort.frames[3].contacts.size(), frame.contacts.size());
}

// Block in the hand of a figure on a block. Each contact carries the weight above it.
TEST(GroundEffort, EachContactOfAStack_CarriesTheWeightAbove) {
  Animation animation = Standing();
  SceneObject block;
  block.name = "block";
  block.shape = Box{{Mat3::Identity(), Vec3(0.0, 0.0, -0.1)}, Vec3(0.5, 0.5, 0.1)};
  animation.scene = {block};
  HeldObject load;
  load.name = "load";
  load.shape = SphereShape{0.05};
  load.mass = 5.0;
  load.holders = {{GroupOf(animation, "r_wrist"), Vec3::Zero(), Holder::kFromTheStart, 15}};
  animation.held_objects.push_back(load);
  const BakedEffort found = BakeEffort(animation);
  const double mass = animation.figure->total_mass();
  EXPECT_NEAR(SumOfContacts(found.effort.frames[5]).z(), (mass + 5.0) * kG, 1e-6);
  EXPECT_NEAR(SumOfContacts(found.effort.frames[20]).z(), mass * kG, 1e-6);
  for (const size_t i : {5, 20}) {
    EXPECT_LT(found.effort.frames[i].from_nowhere.force.norm(), 1e-6);
    EXPECT_LT(found.effort.frames[i].from_nowhere.moment.norm(), 1e-6);
  }
}

// All weights scale with the gravity of the scene.
TEST(GroundEffort, EffortOnTheMoon_IsASixthOfThatOnEarth) {
  Animation animation = Standing();
  animation.gravity = 1.62;
  const BakedEffort found = BakeEffort(animation);
  EXPECT_NEAR(SumOfContacts(found.effort.frames[5]).z(), 1.62 * animation.figure->total_mass(),
              1e-6);
}

}  // namespace
}  // namespace hazumi::test
