#include "engine/body/body_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/spatial/degrees.h"

namespace hazumi::test {
namespace {

using enum BodyRole;
constexpr BodySide kLeftSide = BodySide::kLeft, kRightSide = BodySide::kRight,
                   kNoSide = BodySide::kMiddle;

RestBone At(BodyPlace place, int parent, const Vec3& p) {
  return {place, parent, {Mat3::Identity(), p}, {}};
}

// An arm that hangs on the chest, by the directions of its two bones.
std::vector<RestBone> Arm(const Vec3& upper, const Vec3& fore) {
  const Vec3 shoulder(0.0, 0.2, 1.4);
  return {At({kHips, kNoSide}, -1, Vec3(0.0, 0.0, 0.9)), At({kUpperArm, kLeftSide}, 0, shoulder),
          At({kForearm, kLeftSide}, 1, shoulder + upper),
          At({kHand, kLeftSide}, 2, shoulder + upper + fore)};
}

TEST(BodyAxes, AreTheWorldsWhereArmsHang) {
  const Vec3 down(0.0, 0.0, -0.3);
  for (const Mat3& S : BodyAxesOf(Arm(down, down))) EXPECT_TRUE(S.isIdentity(1e-12));
}

// Palms down: the elbow's hinge, y, is vertical.
TEST(BodyAxes, OfATPoseAreRaisedAboutX) {
  const Vec3 left(0.0, 0.3, 0.0);
  const std::vector<Mat3> S = BodyAxesOf(Arm(left, left));
  const Mat3 raised = Eigen::AngleAxisd(90.0 * kDegree, Vec3::UnitX()).toRotationMatrix();
  EXPECT_TRUE(S[1].isApprox(raised, 1e-12));
  EXPECT_TRUE(S[2].isApprox(raised, 1e-12));
}

// An elbow that is bent by 20 degrees tells how the upper arm is turned.
TEST(BodyAxes, ABentElbowTellsItsHinge) {
  const Vec3 upper(0.0, 0.3, 0.0);
  const double bend = 20.0 * kDegree, aside = 30.0 * kDegree;
  const Vec3 fore = 0.3 * Vec3(std::sin(bend) * std::cos(aside), std::cos(bend),
                               std::sin(bend) * std::sin(aside));
  const std::vector<Mat3> S = BodyAxesOf(Arm(upper, fore));
  EXPECT_LT((S[1].col(1) + upper.cross(fore).normalized()).norm(), 1e-12);
  EXPECT_LT((S[1].col(2) + upper.normalized()).norm(), 1e-12);
  EXPECT_LT((S[2].col(1) - S[1].col(1)).norm(), 1e-12) << "the forearm turns about it";
}

TEST(BodyAxes, FeetAreFlatAndTurnedOutward) {
  const std::vector<RestBone> leg = {At({kHips, kNoSide}, -1, Vec3(0.0, 0.0, 0.9)),
                                     At({kThigh, kRightSide}, 0, Vec3(0.0, -0.1, 0.9)),
                                     At({kShin, kRightSide}, 1, Vec3(0.0, -0.1, 0.5)),
                                     At({kFoot, kRightSide}, 2, Vec3(0.0, -0.1, 0.1)),
                                     At({kToe, kRightSide}, 3, Vec3(0.1, -0.15, 0.02))};
  const std::vector<Mat3> S = BodyAxesOf(leg);
  const Mat3 outward = Eigen::AngleAxisd(std::atan2(-0.05, 0.1), Vec3::UnitZ()).toRotationMatrix();
  EXPECT_TRUE(S[3].isApprox(outward, 1e-12));
  EXPECT_TRUE(S[4].isApprox(outward, 1e-12));
}

TEST(BodyAxes, TheLeftTellsWhereForwardIs) {
  for (const double facing : {0.0, 0.7, -2.5}) {
    const Mat3 R = Eigen::AngleAxisd(facing, Vec3::UnitZ()).toRotationMatrix();
    const std::vector<RestBone> bones = {At({kThigh, kLeftSide}, -1, R * Vec3(0.0, 0.1, 0.9)),
                                         At({kThigh, kRightSide}, -1, R * Vec3(0.0, -0.1, 0.9))};
    const auto told = FacingOf(bones);
    ASSERT_TRUE(told);
    EXPECT_NEAR(*told, facing, 1e-12);
  }
  EXPECT_FALSE(FacingOf({At({kThigh, kLeftSide}, -1, Vec3(0.0, 0.1, 0.9))}));
}

}  // namespace
}  // namespace hazumi::test
