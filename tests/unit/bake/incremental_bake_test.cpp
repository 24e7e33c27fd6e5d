// Baking after an edit: bit-equal to baking anew, and no more work than the edit asks for.

#include "engine/bake/incremental_bake.h"

#include <gtest/gtest.h>

#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"
#include "tests/support/long_timeline.h"
#include "tests/support/random.h"

namespace hazumi::test {
namespace {

Animation Example(const std::string& name) {
  const std::string path = HAZUMI_SOURCE_DIR "/assets/examples/" + name + ".kfa";
  return CompileAnimation(LoadProject(path).value()).value().animation;
}

void ExpectSameReport(const RegionReport& a, const RegionReport& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.islands, b.islands);
  EXPECT_EQ(a.bodies, b.bodies);
  EXPECT_EQ(a.error_estimate, b.error_estimate);
}

void ExpectSameMotion(const Motion& a, const Motion& b) {
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (size_t f = 0; f < a.frames.size(); ++f) {
    ASSERT_TRUE(IsSame(a.frames[f], b.frames[f])) << "frame " << f;
    ASSERT_EQ(a.frames[f].pinned, b.frames[f].pinned) << "frame " << f;
    ASSERT_EQ(a.frames[f].in_region, b.frames[f].in_region) << "frame " << f;
  }
  ASSERT_EQ(a.events.size(), b.events.size());
  for (size_t i = 0; i < a.events.size(); ++i) {
    EXPECT_EQ(a.events[i].kind, b.events[i].kind);
    EXPECT_EQ(a.events[i].time, b.events[i].time);
    EXPECT_EQ(a.events[i].joint, b.events[i].joint);
  }
  ASSERT_EQ(a.warnings.size(), b.warnings.size());
  for (size_t i = 0; i < a.warnings.size(); ++i) {
    EXPECT_EQ(a.warnings[i].message, b.warnings[i].message);
  }
  ASSERT_EQ(a.placement_jumps.size(), b.placement_jumps.size());
  for (size_t i = 0; i < a.placement_jumps.size(); ++i) {
    EXPECT_EQ(a.placement_jumps[i].frame, b.placement_jumps[i].frame);
    EXPECT_EQ(a.placement_jumps[i].speed, b.placement_jumps[i].speed);
    EXPECT_EQ(a.placement_jumps[i].distance, b.placement_jumps[i].distance);
  }
  ASSERT_EQ(a.regions.size(), b.regions.size());
  for (size_t r = 0; r < a.regions.size(); ++r) ExpectSameReport(a.regions[r], b.regions[r]);
}

// The same motion, or the same error.
void ExpectSameAsBake(const Animation& animation, IncrementalBake* bake) {
  const Result<Motion> whole = Bake(animation);
  const std::optional<Error> error = bake->Finish();
  ASSERT_EQ(whole.ok(), !error.has_value());
  if (!error) return ExpectSameMotion(bake->motion(), whole.value());
  EXPECT_EQ(whole.error().ToString(), error->ToString());
}

Keys* AnyKeys(Animation* animation, Random* random) {
  const int joints = static_cast<int>(animation->joint_keys.size());
  const int curve = random->Integer(0, joints + kNumRootCurves - 1);
  return curve < joints ? &animation->joint_keys[curve] : &animation->root_keys[curve - joints];
}

// What an animator does to a curve: moves a key up or down or in time, adds one, removes one.
void EditKeys(Animation* animation, Random* random) {
  Keys* keys = AnyKeys(animation, random);
  const int last = animation->last_frame;
  const int what = keys->empty() ? 2 : random->Integer(0, 3);
  const size_t at = keys->empty() ? 0 : random->Integer(0, static_cast<int>(keys->size()) - 1);
  if (what == 0) (*keys)[at].value += random->Uniform(-0.03, 0.03);
  if (what == 1) (*keys)[at].rate = random->Uniform(-1.0, 1.0);
  if (what == 3) keys->erase(keys->begin() + static_cast<long>(at));
  if (what != 2) return;
  const double frame = random->Chance(0.8) ? random->Integer(0, last) : random->Uniform(0.0, last);
  const auto is_before = [](const Key& key, double f) { return key.frame < f; };
  const auto place = std::lower_bound(keys->begin(), keys->end(), frame, is_before);
  if (place != keys->end() && place->frame == frame) return;
  const double value = place == keys->end() ? 0.0 : place->value + 0.02;
  keys->insert(place, {frame, value, {}, Interpolation(random->Integer(0, 3))});
}

void EditRegion(Animation* animation, Random* random) {
  if (animation->regions.empty()) return;
  const int count = static_cast<int>(animation->regions.size());
  DynamicsRegion& region = animation->regions[random->Integer(0, count - 1)];
  if (random->Chance(0.5)) region.friction[0] = random->Uniform(0.2, 1.0);
  if (random->Chance(0.3)) region.last_frame -= region.last_frame - region.first_frame > 4;
  if (random->Chance(0.2)) region.limit_tangents = !region.limit_tangents;
  if (random->Chance(0.2)) region.blend_frames = random->Integer(0, 9);
  for (Drive& drive : region.drives) {
    if (!random->Chance(0.3)) continue;
    if (drive.kind == DriveKind::kSpring) drive.frequency = random->Uniform(0.5, 5.0);
    if (drive.kind == DriveKind::kTorque) drive.torque[1].value = random->Uniform(-5.0, 5.0);
  }
}

// Its joints keyed on every frame, as they move without dynamics, and its regions with a blend.
Animation Recorded(Animation animation) {
  Animation keyed = animation;
  keyed.regions.clear();
  const Motion motion = BakeOrFail(keyed);
  for (size_t j = 0; j < animation.joint_keys.size(); ++j) {
    animation.joint_keys[j].clear();
    for (const MotionFrame& frame : motion.frames) {
      animation.joint_keys[j].push_back(
          {1.0 * frame.frame, frame.q[static_cast<int>(j)], {}, Interpolation::kCubic});
    }
  }
  for (DynamicsRegion& region : animation.regions) region.blend_frames = 8;
  return animation;
}

void ExpectEditsAreSame(Animation animation, int edits, uint64_t seed) {
  Random random(seed);
  IncrementalBake bake(animation);
  const Animation original = animation;
  for (int edit = 0; edit < edits; ++edit) {
    SCOPED_TRACE("edit " + std::to_string(edit));
    if (edit % 10 == 9) animation = original;
    random.Chance(0.8) ? EditKeys(&animation, &random) : EditRegion(&animation, &random);
    bake.Update(animation);
    if (random.Chance(0.3)) {
      (void)bake.BakeTo(random.Integer(animation.first_frame, animation.last_frame));
      continue;
    }
    ExpectSameAsBake(animation, &bake);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(IncrementalBake, OfTheThrowIsSameAsBakingAnew) {
  ExpectEditsAreSame(Example("throw"), 200, 1);
}

TEST(IncrementalBake, OfTheJumpIsSameAsBakingAnew) { ExpectEditsAreSame(Example("jump"), 200, 2); }

// From the right hand by the left one into the air, while both arms swing and after.
TEST(IncrementalBake, OfABallThatChangesHandsIsSameAsBakingAnew) {
  Animation animation = Example("throw");
  std::vector<Holder>& holders = animation.held_objects[0].holders;
  holders[0].last_frame = 7;
  holders.push_back({GroupOf(animation, "l_wrist"), Vec3(0.0, 0.05, -0.1), 7, 12});
  holders.push_back({GroupOf(animation, "r_wrist"), Vec3(0.0, 0.05, -0.1), 18, 22});
  ExpectEditsAreSame(animation, 100, 7);
}

TEST(IncrementalBake, OfATumbleIsSameAsBakingAnew) {
  Animation animation = Example("jump");
  AddRegion(&animation, "tumble", 8, 16, {"r_shoulder"}, 0.8).root = true;
  ExpectEditsAreSame(animation, 25, 5);
}

TEST(IncrementalBake, OfTheThrowByThePapersMethodIsSameAsBakingAnew) {
  Animation animation = Example("throw");
  animation.solver.method = Method::kPaper;
  for (DynamicsRegion& region : animation.regions) region.method = Method::kPaper;
  ExpectEditsAreSame(animation, 100, 3);
}

// One arm is pulled to its keys, so that those inside the region count too, the other is pushed.
TEST(IncrementalBake, OfArmsWithMuscleIsSameAsBakingAnew) {
  Animation animation = Example("throw");
  DynamicsRegion& region = animation.regions[0];
  Drive spring, torque;
  spring.kind = DriveKind::kSpring;
  spring.frequency = 2.0;
  spring.damping_ratio = 0.7;
  torque.torque = {{5, 2.0, {}}, {9, -3.0, {}}, {12.5, 1.0, {}, Interpolation::kHold}};
  const JointIndex left = JointOf(animation, "l_shoulder");
  for (const JointIndex j : region.joints) {
    const bool is_left = animation.figure->IsBeyond(j, left);
    (is_left ? torque : spring).joints.push_back(j);
  }
  ASSERT_FALSE(spring.joints.empty());
  ASSERT_FALSE(torque.joints.empty());
  region.drives = {spring, torque};
  ExpectEditsAreSame(animation, 100, 8);
}

TEST(IncrementalBake, OfARecordingWithBlendsIsSameAsBakingAnew) {
  ExpectEditsAreSame(Recorded(Example("throw")), 150, 6);
}

// A key that the blend passes over but that shapes its arrival, and one beyond.
TEST(IncrementalBake, OfABlendFeelsTheKeysAroundItsTarget) {
  Animation animation = Recorded(Example("throw"));
  IncrementalBake bake(animation);
  ASSERT_FALSE(bake.Finish());
  for (const int frame : {22, 23, 24}) {
    const Motion before = bake.motion();
    KeysOf(&animation, "r_elbow_flexion")[frame].value += 0.05;
    bake.Update(animation);
    ExpectSameAsBake(animation, &bake);
    EXPECT_FALSE(IsSame(before.frames[17], bake.motion().frames[17])) << frame;
  }
}

TEST(IncrementalBake, OfALongTimelineIsSameAsBakingAnew) {
  ExpectEditsAreSame(LongTimeline(600, 6), 60, 4);
}

// Left and right arm do not feel each other: the right one is not solved again.
TEST(IncrementalBake, SolvesOnlyTheGroupsThatFeelTheEdit) {
  Animation animation = Example("throw");
  IncrementalBake bake(animation);
  ASSERT_FALSE(bake.Finish());
  const double before = bake.motion().regions[0].microseconds;
  Keys& keys = KeysOf(&animation, "neck_flexion");
  keys[1].value += 0.05;
  bake.Update(animation);
  ASSERT_FALSE(bake.Finish());
  // Neither arm feels the neck: what it took to solve them is what it took before.
  EXPECT_EQ(bake.motion().regions[0].microseconds, before);
}

TEST(IncrementalBake, BakesOnlyWhatTheEditReaches) {
  Animation animation = LongTimeline(600, 6);
  IncrementalBake bake(animation);
  ASSERT_FALSE(bake.Finish());
  const int all = bake.stretches_baked();
  animation.joint_keys[JointOf(animation, "neck_flexion").value()][5].value += 0.01;
  bake.Update(animation);
  EXPECT_TRUE(bake.is_fresh(5));
  ASSERT_FALSE(bake.Finish());
  EXPECT_LE(bake.stretches_baked() - all, all / 5);
}

TEST(IncrementalBake, CountsTheWorkOfEachBakeAlsoOfOneThatFails) {
  Animation animation = Example("throw");
  IncrementalBake bake(animation);
  EXPECT_EQ(bake.work(), 0.0);
  ASSERT_FALSE(bake.Finish());
  const double first = bake.work();
  EXPECT_GT(first, 0.0);
  animation.solver.tolerance /= 1e3;  // begins anew
  bake.Update(animation);
  ASSERT_FALSE(bake.Finish());
  const double second = bake.work();
  EXPECT_GT(second, 2.0 * first);
  Keys& keys = KeysOf(&animation, "r_shoulder_flexion");
  for (Key& key : keys) key.rate = 1e15;
  bake.Update(animation);
  ASSERT_TRUE(bake.Finish());
  EXPECT_GT(bake.work(), second);
}

TEST(IncrementalBake, BakesNoFurtherThanAskedFor) {
  IncrementalBake bake(LongTimeline(600, 6));
  EXPECT_FALSE(bake.is_fresh(0));
  ASSERT_FALSE(bake.BakeTo(100));
  EXPECT_TRUE(bake.is_fresh(100));
  EXPECT_FALSE(bake.is_fresh(300));
  EXPECT_EQ(bake.motion().frames[100].frame, 100);
  ASSERT_FALSE(bake.BakeTo(10000));  // beyond its end
  EXPECT_TRUE(bake.is_fresh(600));
}

TEST(IncrementalBake, GoesOnAfterAnError) {
  Animation animation = Example("throw");
  const Animation good = animation;
  IncrementalBake bake(animation);
  ASSERT_FALSE(bake.Finish());
  animation.root_keys[kRootZ][1].value += 3.0;  // its feet cannot stay on the floor
  bake.Update(animation);
  const std::optional<Error> error = bake.Finish();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->ToString(), BakeError(animation).ToString());
  EXPECT_TRUE(bake.Finish());
  bake.Update(good);
  ExpectSameAsBake(good, &bake);
}

TEST(IncrementalBake, GoesOnAfterAnInterruption) {
  std::atomic<bool> cancel = true;
  BakeOptions options;
  options.cancel = &cancel;
  const Animation animation = Example("jump");
  IncrementalBake bake(animation, options);
  const std::optional<Error> error = bake.Finish();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code, ErrorCode::kInterrupted);
  cancel = false;
  ExpectSameAsBake(animation, &bake);
}

}  // namespace
}  // namespace hazumi::test
