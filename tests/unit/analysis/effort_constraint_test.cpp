// Effort of figures that constraints hold: what these give is nobody's effort.

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/analysis/effort.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/unit/analysis/baked_effort.h"
#include "tests/unit/bake/constraint_cases.h"

namespace hazumi::test {
namespace {

// Of hinges that a region moves, in frames before anything is hit [N m].
double LargestLimpTorque(const BakedEffort& found) {
  double largest = 0.0;
  const std::vector<MotionEvent> hits = EventsOf(found.motion, EventKind::kLimit);
  for (size_t i = 0; i + 1 < found.motion.frames.size(); ++i) {
    const MotionFrame& frame = found.motion.frames[i];
    if (!hits.empty() && frame.frame >= hits.front().frame - 1) break;
    for (int j = 0; j < frame.q.size(); ++j) {
      if (!frame.in_region[static_cast<size_t>(j)]) continue;
      largest = std::max(largest, std::abs(found.effort.frames[i].tau[j]));
    }
  }
  return largest;
}

TEST(HeldEffort, OfLimpArmsWhoseHandsAreHeldIsNone) {
  Animation animation = HandsOnBar();
  animation.last_frame = 30;
  for (DynamicsRegion& region : animation.regions) {
    std::fill(region.friction.begin(), region.friction.end(), 1.0);
  }
  const BakedEffort found = BakeEffort(animation);
  EXPECT_GT(found.motion.frames[5].constraint_forces.at(0), 1.0);
  EXPECT_LT(LargestLimpTorque(found), 1e-6);
}

// What a hand holds on to does not carry it once more because it touches that.
TEST(HeldEffort, OfALimpArmOnABarThatItTouchesIsNone) {
  Animation animation = HandsOnBar();
  animation.last_frame = 30;
  AddFloor(&animation);
  for (const Constraint& grip : animation.constraints) {
    Box bar;
    bar.X_WB.p = grip.b.offset - 0.02 * Vec3::UnitZ();
    bar.half_size = Vec3(0.02, 0.3, 0.02);
    SceneObject object;
    object.name = "bar";
    object.shape = bar;
    animation.scene.push_back(object);
  }
  for (DynamicsRegion& region : animation.regions) {
    std::fill(region.friction.begin(), region.friction.end(), 1.0);
  }
  EXPECT_LT(LargestLimpTorque(BakeEffort(animation)), 1e-6);
}

// Whichever end is named first.
TEST(HeldEffort, OfAnArmThatIsLedByTheOtherOneIsTheOtherOnes) {
  for (const bool is_swapped : {false, true}) {
    Animation animation = Exact(Human37(), kG);
    AddRegion(&animation, "arm", 0, 30, {"l_shoulder"}, 1.0).method = Method::kExact;
    KeysOf(&animation, "r_shoulder_y") = {{0, -0.2, {}}, {15, -0.9, {}}, {30, -0.3, {}}};
    KeysOf(&animation, "r_elbow_y") = {{0, -1.5, {}}, {30, -1.8, {}}};
    const char *a = is_swapped ? "r_wrist" : "l_wrist", *b = is_swapped ? "l_wrist" : "r_wrist";
    AddPoint(&animation, OnJoint(animation, a), OnJoint(animation, b), 0, 30).arrive_frames = 8;
    EXPECT_LT(LargestLimpTorque(BakeEffort(animation)), 1e-6) << is_swapped;
  }
}

TEST(HeldEffort, OfARodThatIsHeldAtItsEndNothingComesFromNowhere) {
  for (const ConstraintKind kind : {ConstraintKind::kPoint, ConstraintKind::kWeld}) {
    Animation animation = Flying(FreeRod(), kG);
    const Vec3 end(-0.5 * kLength, 0.0, 0.0);
    AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30).kind = kind;
    const BakedEffort found = BakeEffort(animation);
    for (size_t i = 0; i < 30; ++i) {
      EXPECT_LT(found.effort.frames[i].from_nowhere.force.norm(), 1e-6) << i;
      EXPECT_LT(found.effort.frames[i].from_nowhere.moment.norm(), 1e-6) << i;
    }
  }
}

TEST(HeldEffort, OfADistanceNothingComesFromNowhere) {
  Animation animation = Flying(FreeRod(), kG);
  SetRoot(&animation, kRootX, 0.5, 0.0);
  Constraint& cord =
      AddPoint(&animation, OnRoot(Vec3(0.1, 0.0, 0.0)), InWorld(Vec3::Zero()), 0, 30);
  cord.kind = ConstraintKind::kDistance;
  cord.length = 0.6;
  const BakedEffort found = BakeEffort(animation);
  for (size_t i = 0; i < 30; ++i) {
    EXPECT_LT(found.effort.frames[i].from_nowhere.force.norm(), 1e-6) << i;
  }
}

// Hands on the high bar carry the body, and then it flies.
TEST(HeldEffort, OfTheHighBarIsCarriedByTheHands) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/bar.kfa";
  const Animation animation = CompileAnimation(LoadProject(path).value()).value().animation;
  const BakedEffort found = BakeEffort(animation);
  const double weight = animation.figure->total_mass() * kG;
  for (int i = 0; i < animation.regions[0].last_frame; ++i) {
    EXPECT_LT(found.effort.frames[i].from_nowhere.force.norm(), 1e-3 * weight) << i;
  }
  const auto brief = BriefEffortReport(animation, found.motion, found.effort);
  ASSERT_EQ(brief.size(), 1u);
  EXPECT_TRUE(brief[0].starts_with("largest effort: ")) << brief[0];
}

}  // namespace
}  // namespace hazumi::test
