// What touches the scene in regions with contacts is told, and is nobody's effort.

#include <gtest/gtest.h>

#include "tests/unit/analysis/baked_effort.h"
#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

Vec3 SumOf(const MotionFrame& frame) {
  Vec3 sum = Vec3::Zero();
  for (const ContactPush& push : frame.contacts.pushes) sum += push.force;
  return sum;
}

void PutRootAt(Animation* animation, double z) {
  animation->root_keys[kRootZ] = {{0, z, 0.0, kHold}};
}

TEST(TouchingEffort, ABallThatLiesStillIsPushedByItsWeight) {
  Animation animation = Loose(FreeCapsule(0.0, kBallRadius), 40);
  AddFloor(&animation);
  PutRootAt(&animation, 0.5);
  const Motion motion = BakeOrFail(animation);
  EXPECT_TRUE(motion.frames[3].contacts.pushes.empty());
  for (const size_t i : {20, 30, 40}) {
    const MotionFrame& frame = motion.frames[i];
    EXPECT_LT((SumOf(frame) - kMass * kG * Vec3::UnitZ()).norm(), 1e-3 * kMass * kG) << i;
    for (const ContactPush& push : frame.contacts.pushes) {
      EXPECT_EQ(push.link, 0);
      EXPECT_EQ(push.object, 0);
      EXPECT_LT((push.p - Vec3(frame.X_WR.p.x(), frame.X_WR.p.y(), 0.0)).norm(), 1e-6);
    }
  }
}

// Down a slope, where it slides.
TEST(TouchingEffort, FrictionIsPartOfThePush) {
  Animation animation = Loose(FreeCapsule(0.3, 0.1), 20);
  const double angle = 0.5, friction = 0.2;
  const Vec3 down = AddIncline(&animation, angle, friction);
  animation.root_keys[kRootAngleY] = {{0, angle, 0.0, kHold}};
  const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
  for (int i = 0; i < 3; ++i) animation.root_keys[i] = {{0, 0.1 * normal[i], 0.0, kHold}};
  const Motion motion = BakeOrFail(animation);
  const Vec3 push = kMass * kG * std::cos(angle) * (normal - friction * down);
  EXPECT_LT((SumOf(motion.frames[10]) - push).norm(), 1e-6 * push.norm());
}

// While contacts change one by one, while they are frozen, and when it lies still.
TEST(TouchingEffort, OfAChainThatFallsNothingComesFromNowhere) {
  Animation animation = Loose(*Chain().figure, 120, {"one"});
  animation.regions[0].friction.assign(animation.regions[0].joints.size(), 0.8);
  AddFloor(&animation);
  PutRootAt(&animation, 0.8);
  const BakedEffort found = BakeEffort(animation);
  const double mass = animation.figure->total_mass();
  int touched = 0;
  for (size_t i = 0; i < found.motion.frames.size(); ++i) {
    const MotionFrame& frame = found.motion.frames[i];
    const FrameEffort& effort = found.effort.frames[i];
    EXPECT_LT(effort.from_nowhere.force.norm(), 1e-6 * mass * kG) << i;
    EXPECT_LT(effort.from_nowhere.moment.norm(), 1e-6 * mass * kG) << i;
    EXPECT_EQ(effort.contacts.size(), frame.contacts.pushes.size()) << i;
    touched += !frame.contacts.pushes.empty();
    for (const ContactPush& push : frame.contacts.pushes) {
      EXPECT_EQ(push.object, 0) << i;
      EXPECT_GE(push.link, 0) << i;
      EXPECT_NEAR(push.p.z(), 0.0, 1e-3) << i;
    }
  }
  EXPECT_GT(touched, 60);
  EXPECT_LT((SumOf(found.motion.frames.back()) - mass * kG * Vec3::UnitZ()).norm(),
            1e-3 * mass * kG);
}

}  // namespace
}  // namespace hazumi::test
