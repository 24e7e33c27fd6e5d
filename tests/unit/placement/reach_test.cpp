#include "engine/placement/reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "tests/support/random.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

Vec3 OriginOf(const Figure& figure, const Pose& X_WR, const VecX& q, JointIndex j) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, q, &ws);
  return ws.body(j).p;
}

std::vector<JointIndex> AllHinges(const Figure& figure) {
  std::vector<JointIndex> all;
  for (int j = 0; j < figure.num_joints(); ++j) all.push_back(JointIndex(j));
  return all;
}

JointIndex FirstHinge(const Figure& figure, const char* joint) {
  return figure.group(*figure.FindGroup(joint)).first;
}

VecX WithinLimits(const Figure& figure, test::Random* random) {
  VecX q(figure.num_joints());
  for (int j = 0; j < q.size(); ++j) {
    const Joint& joint = figure.joints()[j];
    q[j] = random->Uniform(std::max(joint.lower, -1.0), std::min(joint.upper, 1.0));
  }
  return q;
}

double LargestExcess(const Figure& figure, const VecX& q) {
  double excess = 0.0;
  for (int j = 0; j < q.size(); ++j) {
    excess = std::max({excess, figure.joints()[j].lower - q[j], q[j] - figure.joints()[j].upper});
  }
  return excess;
}

TEST(Reach, KeepsAnOrientationWhereTheLimbCan) {
  const Figure figure = test::Human();
  test::Random random(7);
  const JointIndex toe = FirstHinge(figure, "l_toe");
  int reached = 0;
  constexpr int kCases = 100;
  for (int i = 0; i < kCases; ++i) {
    const Pose X_WR{random.Rotation(), random.Vector3(1.0)};
    DynamicsWorkspace ws(figure);
    const VecX there = WithinLimits(figure, &random);
    ComputePositions(figure, X_WR, there, &ws);
    const Mat3 foot = ws.body(figure.joint(toe).parent).R;
    VecX q = there;
    for (double& angle : q) angle += random.Uniform(-0.2, 0.2);
    const double left = Reach(figure, {X_WR, toe, ws.body(toe).p, AllHinges(figure), foot}, &q);
    ComputePositions(figure, X_WR, q, &ws);
    const double turned = (ws.body(figure.joint(toe).parent).R - foot).norm();
    if (left > 1e-6) continue;
    ++reached;
    EXPECT_LT(turned, 1e-4);
  }
  EXPECT_GE(reached, kCases * 9 / 10);
}

TEST(Reach, ComesToWhereOtherPosesAre) {
  const Figure figure = test::Human();
  test::Random random(1);
  int reached = 0;
  constexpr int kCases = 200;
  for (int i = 0; i < kCases; ++i) {
    const JointIndex wrist = FirstHinge(figure, "r_wrist");
    const Pose X_WR{random.Rotation(), random.Vector3(1.0)};
    const Vec3 target = OriginOf(figure, X_WR, WithinLimits(figure, &random), wrist);
    VecX q = WithinLimits(figure, &random);
    const double distance = Reach(figure, {X_WR, wrist, target, AllHinges(figure)}, &q);
    EXPECT_NEAR((OriginOf(figure, X_WR, q, wrist) - target).norm(), distance, 1e-12);
    EXPECT_LE(LargestExcess(figure, q), 0.0);
    reached += distance < 1e-8;
  }
  EXPECT_GE(reached, kCases * 95 / 100);
}

TEST(Reach, TurnsTheNamedHingesOnly) {
  const Figure figure = test::Human();
  test::Random random(2);
  const JointIndex wrist = FirstHinge(figure, "l_wrist");
  const std::vector<JointIndex> hinges = {*figure.FindJoint("l_elbow_y"),
                                          FirstHinge(figure, "r_hip")};
  const VecX before = WithinLimits(figure, &random);
  VecX q = before;
  Reach(figure, {Pose(), wrist, Vec3(0.3, 0.1, 0.4), hinges}, &q);
  for (int j = 0; j < q.size(); ++j) {
    if (JointIndex(j) == hinges[0]) {
      EXPECT_NE(q[j], before[j]);
    } else {
      EXPECT_EQ(q[j], before[j]) << j;
    }
  }
}

TEST(Reach, LeavesAPoseThatIsThereAlone) {
  const Figure figure = test::Human();
  test::Random random(3);
  const JointIndex toe = FirstHinge(figure, "r_toe");
  const VecX before = WithinLimits(figure, &random);
  VecX q = before;
  Reach(figure, {Pose(), toe, OriginOf(figure, Pose(), before, toe), AllHinges(figure)}, &q);
  EXPECT_EQ(q, before);
}

// Thigh and shank of 0.4 m.
TEST(Reach, BendsAStraightLimb) {
  const Figure figure = test::Leg();
  const JointIndex ankle = FirstHinge(figure, "ankle");
  VecX q = VecX::Zero(figure.num_joints());
  const Vec3 straight = OriginOf(figure, Pose(), q, ankle);
  const Vec3 target = straight + Vec3(0.0, 0.0, 0.1);
  EXPECT_LE(Reach(figure, {Pose(), ankle, target, AllHinges(figure)}, &q), 1e-9);
  const double knee = q[figure.FindJoint("knee")->value()];
  const double from_hip = (target - OriginOf(figure, Pose(), q, FirstHinge(figure, "hip"))).norm();
  EXPECT_NEAR(from_hip, 0.7, 1e-12);
  EXPECT_NEAR(2.0 * 0.4 * std::cos(0.5 * knee), from_hip, 1e-8);
}

TEST(Reach, OutOfReachStretchesTowardsTheTarget) {
  const Figure figure = test::TwoLinks();
  const JointIndex foot = FirstHinge(figure, "foot");
  VecX q = VecX::Constant(figure.num_joints(), 0.2);
  const Vec3 target(1.0, 0.0, -1.0);
  const Vec3 knee = OriginOf(figure, Pose(), q, FirstHinge(figure, "knee"));
  const double distance = Reach(figure, {Pose(), foot, target, AllHinges(figure)}, &q);
  EXPECT_NEAR(distance, (target - knee).norm() - 0.4, 1e-9);
}

TEST(Reach, SmallMovesOfTheTargetGiveSmallMovesOfThePose) {
  const Figure figure = test::Human();
  test::Random random(4);
  const JointIndex wrist = FirstHinge(figure, "r_wrist");
  VecX q = WithinLimits(figure, &random);
  const Vec3 from = OriginOf(figure, Pose(), q, wrist);
  const Vec3 to = OriginOf(figure, Pose(), WithinLimits(figure, &random), wrist);
  for (int i = 1; i <= 100; ++i) {
    const VecX before = q;
    const Vec3 target = from + (to - from) * (i / 100.0);
    Reach(figure, {Pose(), wrist, target, AllHinges(figure)}, &q);
    EXPECT_LE((q - before).cwiseAbs().maxCoeff(), 0.1) << i;
  }
}

}  // namespace
}  // namespace hazumi
