// Balls that a hand lets go of and that touch the scene, in a bake.

#include <gtest/gtest.h>

#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr int kRelease = 6;
constexpr double kBall = 0.05, kHeight = 1.0;

// An arm that throws a ball onto a floor.
Animation Thrower(bool touches) {
  Animation animation = Exact(TurningRod(), kG);
  animation.last_frame = 90;
  animation.root_keys[kRootZ] = {{0, kHeight, {}, kHold}};
  KeysOf(&animation, "pivot") = {{0, 0.0, {}, kCubic}, {10, 1.5, {}, kCubic}};
  AddFloor(&animation);
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{kBall};
  ball.mass = 0.4;
  ball.holders = {
      {GroupOf(animation, "pivot"), Vec3(kLength, 0.0, 0.0), Holder::kFromTheStart, kRelease}};
  ball.touches_scene = touches;
  ball.restitution = 0.5;
  animation.held_objects = {ball};
  return animation;
}

Vec3 Place(const Motion& motion, size_t frame) { return motion.frames[frame].objects[0].X_WO.p; }

TEST(HeldContact, BouncesWhereItFellThroughTheFloor) {
  const Motion motion = BakeOrFail(Thrower(true)), through = BakeOrFail(Thrower(false));
  const double falls = std::sqrt(2.0 * (kHeight - kBall) / kG);
  const double hit = kRelease / 30.0 + falls, top = hit + 0.5 * falls;
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    const double t = static_cast<double>(f) / 30.0;
    if (t < hit) {
      EXPECT_LT((Place(motion, f) - Place(through, f)).norm(), 1e-9) << f;
    } else {
      EXPECT_GT(Place(motion, f).z(), kBall - 1e-4) << f;
      EXPECT_LT(Place(motion, f).z(), kBall + 0.25 * (kHeight - kBall) + 1e-6) << f;
    }
  }
  EXPECT_LT(Place(through, 90).z(), -1.0);
  const auto f = static_cast<size_t>(top * 30.0);
  const double beside = static_cast<double>(f) / 30.0 - top;
  const double z = kBall + 0.25 * (kHeight - kBall) - 0.5 * kG * beside * beside;
  EXPECT_NEAR(Place(motion, f).z(), z, 1e-6);
  // Then it rolls.
  EXPECT_NEAR(Place(motion, 90).z(), kBall, 1e-6);
  EXPECT_NEAR((Place(motion, 90) - Place(motion, 89)).norm(),
              (Place(motion, 89) - Place(motion, 88)).norm(), 1e-6);
}

TEST(HeldContact, WithNothingToTouchItIsOnItsParabolaToTheBit) {
  Animation with = Thrower(true), without = Thrower(false);
  with.scene.clear();
  without.scene.clear();
  const Motion motion = BakeOrFail(with), expected = BakeOrFail(without);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    EXPECT_TRUE(IsSame(motion.frames[f], expected.frames[f])) << f;
  }
}

TEST(HeldContact, LiesUntilItIsHeldAgain) {
  Animation animation = Thrower(true);
  HeldObject& ball = animation.held_objects[0];
  ball.restitution = 0.0;
  ball.holders.push_back({ball.holders[0].joint, Vec3(kLength, 0.0, 0.0), 60, 70});
  const Motion motion = BakeOrFail(animation);
  EXPECT_NEAR(Place(motion, 59).z(), kBall, 1e-7);
  EXPECT_EQ(motion.frames[60].objects[0].holder, 1);
  EXPECT_NEAR(Place(motion, 65).z(), kHeight, 1e-12);
  // Let go by an arm at rest, it falls straight down.
  EXPECT_NEAR(Place(motion, 90).z(), kBall, 1e-7);
  EXPECT_LT((Place(motion, 90) - Place(motion, 70)).head<2>().norm(), 1e-9);
}

// At twice the frames it is the same motion.
TEST(HeldContact, DoesNotDependOnWhatIsLookedAt) {
  BakeOptions fine;
  fine.output_rate = FrameRate{60, 1};
  const Motion motion = BakeOrFail(Thrower(true)), finer = BakeOrFail(Thrower(true), fine);
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    EXPECT_LT((Place(motion, f) - Place(finer, 2 * f)).norm(), 1e-12) << f;
  }
}

TEST(HeldContact, BallReleasedInsideTheFloor_IsWarnedOf) {
  const auto warnings = [](double height, bool touches) {
    Animation animation = Thrower(touches);
    animation.root_keys[kRootZ] = {{0, height, {}, kHold}};
    return BakeOrFail(animation).warnings;
  };
  const std::vector<Warning> deep = warnings(0.02, true);
  ASSERT_EQ(deep.size(), 1u);
  EXPECT_EQ(deep[0].place, "held_objects[0]");
  EXPECT_EQ(deep[0].frame, kRelease);
  EXPECT_EQ(
      deep[0].message,
      "\"ball\" is let go 30 mm inside \"floor\" in frame 6: it is pushed out slowly; move it "
      "out in that frame");
  EXPECT_TRUE(warnings(0.02, false).empty());
  EXPECT_TRUE(warnings(kBall, true).empty());
}

// Ball that is released on the first frame, where a key states the rate of the arm.
Animation ThrownAtOnce(int version) {
  Animation animation = Thrower(false);
  animation.solver.version = version;
  KeysOf(&animation, "pivot")[0].rate = 2.0;
  animation.held_objects[0].holders[0].last_frame = 0;
  return animation;
}

// Initial velocity of a ball that flies from the first frame on [m/s].
Vec3 StartVelocity(const Animation& animation) {
  const Motion motion = BakeOrFail(animation);
  const double t = 1.0 / 30.0;
  return (Place(motion, 1) - Place(motion, 0)) / t + 0.5 * kG * t * Vec3::UnitZ();
}

TEST(HeldContact, BallReleasedOnTheFirstFrame_TakesTheKeyedVelocity) {
  const Animation animation = ThrownAtOnce(2);
  const Vec3 axis = animation.figure->joint(JointOf(animation, "pivot")).axis;
  const Vec3 v = 2.0 * axis.cross(Vec3(kLength, 0.0, 0.0));
  EXPECT_LT((StartVelocity(animation) - v).norm(), 1e-9);
  EXPECT_LT(StartVelocity(ThrownAtOnce(1)).norm(), 1e-9);  // solver version 1: at rest
}

TEST(HeldContact, BallReleasedOnTheFirstFrame_MovesWithARegionThatBeginsThere) {
  Animation animation = ThrownAtOnce(2);
  const Vec3 keyed = StartVelocity(animation);
  AddRegion(&animation, "arm", 0, 20, {"pivot"}).method = Method::kExact;
  EXPECT_LT((StartVelocity(animation) - keyed).norm(), 1e-9);
}

TEST(HeldContact, BallReleasedOnTheFirstFrame_MovesWithAPinnedFigure) {
  Animation animation = ThrownAtOnce(2);
  const Vec3 of_arm = StartVelocity(animation);
  // Pin at the pivot, which does not change the motion of root and arm.
  AddPin(&animation, 0, 90, "pivot");
  EXPECT_LT((StartVelocity(animation) - of_arm).norm(), 1e-9);
}

}  // namespace
}  // namespace hazumi::test
