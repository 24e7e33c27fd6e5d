#include "engine/figure/figure_bone.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

constexpr double kTurn = 0.8;

Mat3 About(const Vec3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

class FigureBones : public testing::Test {
 protected:
  FigureBones() : figure_(Human37()), q_(VecX::Zero(figure_.num_joints())) {}

  Mat3 TurnOf(const SkinBone& bone) {
    return hazumi::TurnOf(figure_, *FindBone(figure_, bone), q_);
  }
  const Joint& hinge(const char* name) { return figure_.joint(*figure_.FindJoint(name)); }
  double& angle(const char* name) { return q_[figure_.FindJoint(name)->value()]; }

  Figure figure_;
  VecX q_;
};

TEST_F(FigureBones, OfAShareTurnSoFar) {
  angle("r_knee_y") = kTurn;
  EXPECT_TRUE(TurnOf({"r_knee", 0.25}).isApprox(About(hinge("r_knee_y").axis, 0.25 * kTurn)));
  EXPECT_TRUE(TurnOf("r_knee").isApprox(About(hinge("r_knee_y").axis, kTurn)));
}

TEST_F(FigureBones, OfAJointShareAllItsHinges) {
  angle("r_wrist_x") = kTurn;
  angle("r_wrist_y") = -0.3;
  EXPECT_TRUE(TurnOf({"r_wrist", 0.5})
                  .isApprox(About(hinge("r_wrist_x").axis, 0.5 * kTurn) *
                            About(hinge("r_wrist_y").axis, -0.15)));
}

TEST_F(FigureBones, OfAHingeTakeThoseBeforeItInFullAndNoneBehindIt) {
  angle("r_elbow_y") = kTurn;
  angle("r_elbow_z") = 0.6;
  const Mat3 bent = About(hinge("r_elbow_y").axis, kTurn);
  EXPECT_TRUE(TurnOf("r_elbow_y").isApprox(bent));
  EXPECT_TRUE(TurnOf({"r_elbow_z", 0.5}).isApprox(bent * About(hinge("r_elbow_z").axis, 0.3)));
}

TEST_F(FigureBones, OfNoJointAreNotFound) { EXPECT_FALSE(FindBone(figure_, {"tail", 0.5})); }

}  // namespace
}  // namespace hazumi::test
