// Regions in which keys hold the root's orientation against gravity and contacts.

#include "engine/analysis/held_turn.h"

#include <gtest/gtest.h>

#include "tests/unit/analysis/baked_effort.h"
#include "tests/unit/bake/contact_cases.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

// Height [m] and lean [rad] of the shipped human's root.
constexpr double kUpright = 0.9024, kLean = 0.4363;

// Figure that leans forward by 25 degrees and is released, except for its root's orientation.
Animation Leaning() {
  Animation animation = LooseHuman(20, kUpright, kLean);
  animation.regions[0].root = false;
  return animation;
}

std::vector<HeldTurn> TurnsIn(const Animation& animation) {
  BakeOptions options;
  options.accelerations = true;
  return FindHeldTurns(animation, BakeOrFail(animation, options));
}

TEST(HeldTurn, LeaningBody_NeedsTheMomentOfItsWeight) {
  const Animation animation = Leaning();
  const BakedEffort found = BakeEffort(animation);
  const std::vector<HeldTurn> turns = FindHeldTurns(animation, found.motion);
  ASSERT_EQ(turns.size(), 1u);
  double most = 0.0;
  for (const FrameEffort& frame : found.effort.frames) {
    most = std::max(most, frame.from_nowhere.moment.norm());
  }
  EXPECT_NEAR(turns[0].moment, most, 1e-3 * most);
  EXPECT_GT(turns[0].moment, 50.0);
  const std::vector<Warning> warnings = WarningsOf(turns, animation);
  EXPECT_EQ(warnings[0].place, "regions[0].joints");
  EXPECT_NE(warnings[0].message.find("nothing supplies"), std::string::npos);
  EXPECT_EQ(warnings[0].frame, turns[0].frame);
}

TEST(HeldTurn, FreelyTurningBody_HasNoHeldTurn) {
  EXPECT_TRUE(TurnsIn(LooseHuman(20, kUpright, kLean)).empty());
}

TEST(HeldTurn, RegionThatKeepsTheStance_HasNoHeldTurn) {
  Animation animation = Leaning();
  std::vector<JointIndex>& joints = animation.regions[0].joints;
  const JointIndex arm = animation.figure->group(GroupOf(animation, "r_shoulder")).first;
  std::erase_if(joints, [&](JointIndex j) { return !animation.figure->IsBeyond(j, arm); });
  animation.regions[0].friction.resize(joints.size());
  EXPECT_TRUE(TurnsIn(animation).empty());
}

TEST(HeldTurn, Search_NeedsGravityAndContacts) {
  Animation animation = Leaning();
  EXPECT_TRUE(MayHoldTurns(animation));
  animation.regions[0].touches_scene = false;
  EXPECT_FALSE(MayHoldTurns(animation));
  animation = Leaning();
  animation.placements.clear();
  EXPECT_FALSE(MayHoldTurns(animation));
}

// Motion of the window, which has no accelerations; they come from differences.
TEST(HeldTurn, IsFoundWithoutAccelerations) {
  const Animation animation = Leaning();
  const std::vector<HeldTurn> turns = FindHeldTurns(animation, BakeOrFail(animation));
  ASSERT_EQ(turns.size(), 1u);
  EXPECT_GT(turns[0].moment, 50.0);
}

}  // namespace
}  // namespace hazumi::test
