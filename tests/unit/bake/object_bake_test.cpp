// Held objects in a bake.

#include <gtest/gtest.h>

#include "engine/bake/pose/held_objects.h"
#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using namespace test;  // NOLINT: short names for the builders

HeldObject Ball(const Animation& animation, const char* holder, std::optional<int> release) {
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{0.05};
  ball.mass = 0.6;
  ball.holders = {
      {GroupOf(animation, holder), Vec3(0.05, 0.0, -0.12), Holder::kFromTheStart, release}};
  return ball;
}

Animation Throw(std::optional<int> release) {
  Animation animation = Still(Human());
  animation.root_keys[kRootX] = {{0, 0.0, {}, kCubic}, {30, 0.4, {}, kCubic}};
  KeysOf(&animation, "r_shoulder_y") = {{0, 0.5, {}, kCubic}, {12, -2.5, {}, kCubic}};
  KeysOf(&animation, "r_elbow_y") = {{0, -1.5, {}, kCubic}, {12, -0.2, {}, kCubic}};
  animation.held_objects.push_back(Ball(animation, "r_wrist", release));
  return animation;
}

// The last hinge of the wrist carries the ball.
Vec3 OnTheHand(const Animation& animation, const MotionFrame& frame) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  const HeldObject& object = animation.held_objects[0];
  const Holder& holder = object.holders[0];
  const BodyScratch& hand = ws.body(animation.figure->group(holder.joint).last());
  return hand.p + hand.R * holder.offset;
}

TEST(HeldObject, IsWhereItsHolderIsUntilItIsLetGo) {
  const Animation animation = Throw(8);
  const Motion motion = BakeOrFail(animation);
  for (int f = 0; f <= 8; ++f) {
    EXPECT_LE((motion.frames[f].objects[0].X_WO.p - OnTheHand(animation, motion.frames[f])).norm(),
              1e-12);
    EXPECT_EQ(motion.frames[f].objects[0].is_held(), f < 8);
  }
}

TEST(HeldObject, ThenFliesOnAParabolaWithTheVelocityItHad) {
  const Animation animation = Throw(8);
  const Motion motion = BakeOrFail(animation);
  // The hand's motion around frame 8, on the same curves without a release.
  BakeOptions fine;
  fine.output_rate = FrameRate{30000, 1};
  const Motion held = BakeOrFail(Throw({}), fine);
  const auto at = [&](int i) { return OnTheHand(animation, held.frames[i]); };
  const Vec3 v = (8.0 * (at(8001) - at(7999)) - (at(8002) - at(7998))) / 12.0 * 30000.0;
  const Vec3 start = motion.frames[8].objects[0].X_WO.p;
  for (int f = 8; f <= 30; ++f) {
    const double t = (f - 8) / 30.0;
    const Vec3 expected = start + v * t - Vec3(0, 0, 0.5 * kG * t * t);
    EXPECT_LE((motion.frames[f].objects[0].X_WO.p - expected).norm(), 1e-6) << f;
    if (f < 10) continue;
    const auto p = [&](int k) { return motion.frames[k].objects[0].X_WO.p; };
    const Vec3 second = (p(f) - 2.0 * p(f - 1) + p(f - 2)) * 900.0;
    EXPECT_LE((second - Vec3(0, 0, -kG)).norm(), 1e-9) << "exact parabola at " << f;
  }
}

TEST(HeldObject, ReleaseIsAnEvent) {
  const Motion motion = BakeOrFail(Throw(8));
  const auto releases = EventsOf(motion, EventKind::kRelease);
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_EQ(releases[0].frame, 8);
  EXPECT_EQ(releases[0].joint, "r_wrist");
}

TEST(HeldObject, IsPartOfItsHoldersLinkWhileHeld) {
  const Animation animation = Throw(8);
  const Figure loaded = WithObject(*animation.figure, animation.held_objects[0], 0);
  const Motion motion = BakeOrFail(animation);
  for (const int f : {4, 8}) {
    const Figure& figure = f < 8 ? loaded : *animation.figure;
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, motion.frames[f].X_WR, motion.frames[f].q, &ws);
    EXPECT_LE((motion.frames[f].com - CenterOfMass(figure, ws)).norm(), 1e-14) << f;
  }
}

// A region with the ball in the hand is one of a figure whose hand is heavier.
TEST(HeldObject, WeighsOnARegion) {
  Animation with_ball = Throw({});
  AddRegion(&with_ball, "arm", 5, 15, {"r_shoulder"});
  Animation heavier = with_ball;
  heavier.held_objects.clear();
  heavier.figure =
      std::make_shared<const Figure>(WithObject(*with_ball.figure, with_ball.held_objects[0], 0));
  const Motion one = BakeOrFail(with_ball), other = BakeOrFail(heavier);
  for (int f = 0; f <= 30; ++f) EXPECT_EQ(one.frames[f].q, other.frames[f].q) << f;
}

// Nothing pushes or pulls at a release.
TEST(HeldObject, LetGoInFlightChangesNoVelocity) {
  Animation animation = Throw(8);
  animation.root_keys[kRootX] = {{0, 0.0, 1.0, kCubic}};
  animation.root_keys[kRootZ] = {{0, 5.0, 2.0, kCubic}};
  AddGravity(&animation, 0, 30);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& frame = motion.frames[8];
  EXPECT_LE((frame.before.root_v - frame.after.root_v).norm(), 1e-12);
  const Vec3 second = (motion.frames[12].com - 2.0 * motion.frames[11].com + motion.frames[10].com);
  EXPECT_LE((900.0 * second - Vec3(0, 0, -kG)).norm(), 1e-9);
}

// The ball goes from the right hand to the left one on frame 8, whatever is between them.
Animation Pass() {
  Animation animation = Throw(8);
  animation.held_objects[0].holders.push_back(
      {GroupOf(animation, "l_wrist"), Vec3(0.05, 0.0, -0.12), 8, 16});
  return animation;
}

Vec3 InHand(const Animation& animation, const MotionFrame& frame, size_t holder) {
  Animation with = animation;
  with.held_objects[0].holders = {animation.held_objects[0].holders[holder]};
  return OnTheHand(with, frame);
}

TEST(HeldObject, GoesFromHandToHandAndIsLetGoByTheLast) {
  const Animation animation = Pass();
  const Motion motion = BakeOrFail(animation);
  for (int f = 0; f <= 16; ++f) {
    const int holder = f < 8 ? 0 : f < 16 ? 1 : -1;
    EXPECT_EQ(motion.frames[f].objects[0].holder, holder) << f;
    const Vec3 hand = InHand(animation, motion.frames[f], f < 8 ? 0 : 1);
    EXPECT_LE((motion.frames[f].objects[0].X_WO.p - hand).norm(), 1e-12) << f;
  }
  const auto releases = EventsOf(motion, EventKind::kRelease);
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_EQ(releases[0].joint, "l_wrist");
  // The weight goes with it.
  for (const int f : {4, 12, 20}) {
    const Figure figure = WithObject(*animation.figure, animation.held_objects[0],
                                     f < 8    ? 0
                                     : f < 16 ? 1
                                              : -1);
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, motion.frames[f].X_WR, motion.frames[f].q, &ws);
    EXPECT_LE((motion.frames[f].com - CenterOfMass(figure, ws)).norm(), 1e-14) << f;
  }
}

TEST(HeldObject, IsWithWhoHasItAsTheAnimationBeginsWhereverThatIs) {
  for (const int first : {7, 8, 9, 16, 17}) {
    Animation animation = Pass();
    animation.first_frame = first;
    const Motion motion = BakeOrFail(animation);
    const int holder = first < 8 ? 0 : first <= 15 ? 1 : -1;
    EXPECT_EQ(motion.frames[0].objects[0].holder, holder) << first;
    const long releases = static_cast<long>(EventsOf(motion, EventKind::kRelease).size());
    EXPECT_EQ(releases, first <= 16 ? 1 : 0) << first;
  }
}

TEST(HeldObject, ThatJumpsIntoAHandIsWarnedOf) {
  const Animation animation = Pass();
  const Motion motion = BakeOrFail(animation);
  const double gap =
      (InHand(animation, motion.frames[8], 1) - InHand(animation, motion.frames[8], 0)).norm();
  ASSERT_GT(gap, 0.1);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_EQ(motion.warnings[0].frame, 8);
  EXPECT_EQ(
      motion.warnings[0].message,
      "\"ball\" jumps by 1.18 m into joint \"l_wrist\" at frame 8: bring them together there");
}

TEST(HeldObject, FliesFromOneHandToTheOther) {
  Animation animation = Pass();
  animation.held_objects[0].holders[1].first_frame = 12;
  const Motion motion = BakeOrFail(animation), thrown = BakeOrFail(Throw(8));
  for (int f = 8; f < 12; ++f) {
    EXPECT_EQ(motion.frames[f].objects[0].X_WO.p, thrown.frames[f].objects[0].X_WO.p) << f;
  }
  EXPECT_EQ(motion.frames[12].objects[0].holder, 1);
}

TEST(HeldObject, IsWhereItsKeysSayWhileNobodyHasIt) {
  Animation animation = Throw(8);
  HeldObject& ball = animation.held_objects[0];
  ball.holders[0].first_frame = 4;
  for (int axis = 0; axis < 3; ++axis) {
    ball.keys[axis] = {{0, 0.1 * axis, {}, Interpolation::kLinear},
                       {4, 0.5, {}, Interpolation::kLinear},
                       {20, -0.3, {}, Interpolation::kLinear},
                       {24, 0.1, {}, Interpolation::kLinear}};
  }
  const Motion motion = BakeOrFail(animation), thrown = BakeOrFail(Throw(8));
  const auto p = [&](int f) { return motion.frames[f].objects[0].X_WO.p; };
  EXPECT_LE((p(0) - Vec3(0.0, 0.1, 0.2)).norm(), 1e-15);
  EXPECT_LE((p(2) - Vec3(0.25, 0.3, 0.35)).norm(), 1e-15);
  EXPECT_EQ(motion.frames[4].objects[0].holder, 0);
  // It flies to its first key after the release, and no farther.
  for (int f = 8; f < 20; ++f) EXPECT_EQ(p(f), thrown.frames[f].objects[0].X_WO.p) << f;
  EXPECT_LE((p(20) - Vec3::Constant(-0.3)).norm(), 1e-15);
  EXPECT_LE((p(22) - Vec3::Constant(-0.1)).norm(), 1e-15);
  EXPECT_LE((p(30) - Vec3::Constant(0.1)).norm(), 1e-15);
}

// A board in the swinging hand, its long edge along the axis (x, y or z) of the hand when it is not
// turned.
Animation WithBoard(int along, const Mat3& rotation) {
  Animation animation = Throw(12);
  HeldObject& board = animation.held_objects[0];
  board.shape = BoxShape{Vec3::Constant(0.02) + 0.38 * Vec3::Unit(along)};
  board.holders[0].rotation = rotation;
  AddRegion(&animation, "arm", 5, 15, {"r_shoulder"});
  return animation;
}

Mat3 About(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

TEST(HeldObject, IsTurnedInTheHand) {
  const Mat3 turn = About(Vec3(1.0, -2.0, 0.5), 0.7);
  const Animation animation = WithBoard(0, turn);
  const Motion motion = BakeOrFail(animation);
  for (int f = 0; f <= 12; ++f) {
    const MotionFrame& frame = motion.frames[f];
    DynamicsWorkspace ws(*animation.figure);
    ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
    const GroupIndex hand = animation.held_objects[0].holders[0].joint;
    const Mat3 expected = ws.body(animation.figure->group(hand).last()).R * turn;
    EXPECT_LE((frame.objects[0].X_WO.R - expected).norm(), 1e-12) << f;
  }
  // Let go, it turns on from there, as fast as it was turned.
  const auto R = [&](int f) { return motion.frames[f].objects[0].X_WO.R; };
  const Mat3 step = R(14) * R(13).transpose();
  EXPECT_LE((R(13) * R(12).transpose() - step).norm(), 1e-9);
  EXPECT_GT((step - Mat3::Identity()).norm(), 1e-3);
}

// What is turned by a quarter swings as what is as long along the other axis.
TEST(HeldObject, WeighsOnARegionAsItIsTurned) {
  const Mat3 quarter = About(Vec3::UnitZ(), 0.5 * 3.14159265358979323846);
  const Motion turned = BakeOrFail(WithBoard(0, quarter));
  const Motion swapped = BakeOrFail(WithBoard(1, Mat3::Identity()));
  const Motion unturned = BakeOrFail(WithBoard(0, Mat3::Identity()));
  double other = 0.0;
  for (int f = 0; f <= 30; ++f) {
    for (Eigen::Index j = 0; j < turned.frames[f].q.size(); ++j) {
      EXPECT_NEAR(turned.frames[f].q[j], swapped.frames[f].q[j], 1e-9) << f;
      other = std::max(other, std::abs(turned.frames[f].q[j] - unturned.frames[f].q[j]));
    }
  }
  EXPECT_GT(other, 1e-3);
}

TEST(HeldObject, IsTurnedAnotherWayInTheNextHand) {
  Animation animation = Pass();
  animation.held_objects[0].holders[1].rotation = About(Vec3::UnitX(), 0.3);
  const Motion motion = BakeOrFail(animation), unturned = BakeOrFail(Pass());
  const auto turn = [&](int f) {
    return Mat3(unturned.frames[f].objects[0].X_WO.R.transpose() *
                motion.frames[f].objects[0].X_WO.R);
  };
  EXPECT_EQ(turn(7), Mat3(unturned.frames[7].objects[0].X_WO.R.transpose() *
                          unturned.frames[7].objects[0].X_WO.R));
  for (int f = 8; f < 16; ++f) {
    EXPECT_LE((turn(f) - About(Vec3::UnitX(), 0.3)).norm(), 1e-12) << f;
  }
}

}  // namespace
}  // namespace hazumi
