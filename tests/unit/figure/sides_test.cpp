#include "engine/figure/sides.h"

#include <gtest/gtest.h>

#include "tests/support/capture_skeletons.h"
#include "tests/support/figures.h"

namespace hazumi::test {
namespace {

// A joint with one hinge, at a place in its parent's frame.
JointSpec Bone(const std::string& name, const std::string& parent, const Vec3& offset) {
  JointSpec joint{name, parent, offset, Mat3::Identity(), {}, {}};
  joint.hinges.push_back({"", Vec3::UnitY(), -1.0, 1.0});
  joint.links.resize(1);
  joint.links[0].name = "rod";
  joint.links[0].to = Vec3(0.0, 0.0, -0.1);
  joint.links[0].radius = 0.02;
  joint.links[0].mass = 1.0;
  return joint;
}

Figure Of(const std::vector<JointSpec>& joints) {
  FigureSpec spec;
  spec.name = "figure";
  spec.root_name = "hips";
  spec.joints = joints;
  return Build(spec);
}

std::string Other(const Figure& figure, const std::string& name) {
  return FigureSides(figure).OtherSideOf(name, figure);
}

BodySide SideOf(const Figure& figure, const std::string& joint) {
  return FigureSides(figure).SideOf(*figure.FindGroup(joint));
}

TEST(FigureSides, TheShippedHumansJointsAndHingesAreInPairs) {
  const Figure figure = Human37();
  const FigureSides sides(figure);
  int num_pairs = 0;
  for (const Joint& joint : figure.joints()) {
    std::string expected = joint.name;
    if (joint.name.starts_with("l_")) expected[0] = 'r';
    if (joint.name.starts_with("r_")) expected[0] = 'l';
    EXPECT_EQ(sides.OtherSideOf(joint.name, figure), expected);
    num_pairs += joint.name.starts_with("l_") ? 1 : 0;
  }
  EXPECT_GT(num_pairs, 10);
  EXPECT_EQ(sides.normal(), Vec3::UnitY());
  EXPECT_EQ(sides.OtherSideOf("r_shoulder", figure), "l_shoulder");
  EXPECT_EQ(sides.OtherSideOf("no such joint", figure), "no such joint");
}

TEST(FigureSides, RolesGoBeforeNames) {
  std::vector<JointSpec> joints = {Bone("b1", "hips", {0.0, 0.1, 0.0}),
                                   Bone("right_b", "hips", {0.0, -0.1, 0.0}),
                                   Bone("left_b", "hips", {0.0, 0.3, 0.0})};
  joints[0].body = BodyPlace{BodyRole::kThigh, BodySide::kLeft};
  joints[1].body = BodyPlace{BodyRole::kThigh, BodySide::kRight};
  joints[2].body = BodyPlace();
  const Figure figure = Of(joints);
  EXPECT_EQ(Other(figure, "b1"), "right_b");
  EXPECT_EQ(Other(figure, "left_b"), "left_b");
  EXPECT_EQ(SideOf(figure, "b1"), BodySide::kLeft);
}

TEST(FigureSides, ANameIsPairedOnlyWithOneThatIsThere) {
  const Figure figure =
      Of({Bone("lower_leg", "hips", {0.0, 0.1, 0.0}), Bone("relax", "hips", {0.0, 0.2, 0.0}),
          Bone("left_hip", "hips", {0.0, 0.3, 0.0})});
  for (const char* name : {"lower_leg", "relax", "left_hip"}) EXPECT_EQ(Other(figure, name), name);
  EXPECT_EQ(SideOf(figure, "lower_leg"), BodySide::kMiddle);
  EXPECT_EQ(SideOf(figure, "left_hip"), BodySide::kLeft);
  EXPECT_EQ(FigureSides(figure).normal(), Vec3::UnitY());
}

TEST(FigureSides, LettersWithoutASeparatorAreASideIfBothAreThere) {
  const Figure figure =
      Of({Bone("rfemur", "hips", {-0.1, 0.0, 0.0}), Bone("lfemur", "hips", {0.1, 0.0, 0.0}),
          Bone("rtibia", "rfemur", {0.0, 0.0, -0.4}), Bone("ltibia", "lfemur", {0.0, 0.0, -0.4})});
  EXPECT_EQ(Other(figure, "rfemur"), "lfemur");
  EXPECT_EQ(Other(figure, "ltibia"), "rtibia");
  EXPECT_EQ(SideOf(figure, "rtibia"), BodySide::kRight);
  EXPECT_EQ(SideOf(figure, "lfemur"), BodySide::kLeft);
  EXPECT_EQ(FigureSides(figure).normal(), Vec3::UnitX());
}

// As in a well-known sample file: numbers that count differently on the two sides.
TEST(FigureSides, ChainsWhoseNamesDoNotAgreeArePairedByWhatTheyHangOn) {
  const Figure figure =
      Of({Bone("torso", "hips", {0.0, 0.0, 0.3}), Bone("arm_L__4_", "torso", {0.0, 0.1, 0.2}),
          Bone("arm_L__3_", "arm_L__4_", {0.0, 0.2, 0.0}),
          Bone("arm_L__2_", "arm_L__3_", {0.0, 0.2, 0.0}), Bone("arm_R", "torso", {0.0, -0.1, 0.2}),
          Bone("arm_R__2_", "arm_R", {0.0, -0.2, 0.0}),
          Bone("arm_R__3_", "arm_R__2_", {0.0, -0.2, 0.0}), Bone("head", "torso", {0, 0, 0.4})});
  EXPECT_EQ(Other(figure, "arm_L__4_"), "arm_R");
  EXPECT_EQ(Other(figure, "arm_R__2_"), "arm_L__3_");
  EXPECT_EQ(Other(figure, "arm_L__2_"), "arm_R__3_");
  EXPECT_EQ(Other(figure, "head"), "head");
}

TEST(FigureSides, WhatHangsOnASideIsOnIt) {
  const Figure figure =
      Of({Bone("hand.l", "hips", {0.0, 0.4, 0.0}), Bone("hand.r", "hips", {0.0, -0.4, 0.0}),
          Bone("sword", "hand.r", {0.3, 0.0, 0.0}), Bone("grip", "sword", {0.1, 0.0, 0.0})});
  EXPECT_EQ(SideOf(figure, "sword"), BodySide::kRight);
  EXPECT_EQ(SideOf(figure, "grip"), BodySide::kRight);
  EXPECT_EQ(Other(figure, "sword"), "sword");
}

TEST(FigureSides, TheNormalIsAnAxisUnlessNoneIsNear) {
  const auto normal = [](double degrees) {
    const Mat3 turned =
        Eigen::AngleAxisd(degrees / 57.29577951308232, Vec3::UnitZ()).toRotationMatrix();
    return FigureSides(Build(CaptureSpec(turned))).normal();
  };
  EXPECT_EQ(normal(8.0), Vec3::UnitY());
  EXPECT_EQ(normal(90.0), Vec3::UnitX());
  EXPECT_LE((normal(30.0) - Vec3(-0.5, std::sqrt(0.75), 0.0)).norm(), 1e-12);
}

TEST(FigureSides, HingesThatAreCalledDifferentlyArePairedInTheirOrder) {
  FigureSpec spec = CaptureSpec();
  for (JointSpec& joint : spec.joints) {
    if (joint.name == "RightArm") joint.hinges[0].name = "twist";
  }
  const Figure figure = Build(spec);
  EXPECT_EQ(Other(figure, "LeftArm_z"), "RightArm_twist");
  EXPECT_EQ(Other(figure, "LeftArm_y"), "RightArm_y");
  EXPECT_EQ(Other(figure, "LHipJoint"), "RHipJoint");
}

}  // namespace
}  // namespace hazumi::test
