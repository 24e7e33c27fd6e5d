#include "engine/figure/side_names.h"

#include <gtest/gtest.h>

#include <set>

namespace hazumi::test {
namespace {

TEST(SideNames, EveryCommonSpellingHasItsOtherSide) {
  for (const auto& [left, right] : std::vector<std::pair<std::string, std::string>>{
           {"l_elbow", "r_elbow"},
           {"upperarm.l", "upperarm.r"},
           {"upper_leg.L.001", "upper_leg.R.001"},
           {"LeftArm", "RightArm"},
           {"mixamorig:LeftForeArm", "mixamorig:RightForeArm"},
           {"Arm_L", "Arm_R"},
           {"ArmL", "ArmR"},
           {"lThigh", "rThigh"},
           {"LHipJoint", "RHipJoint"},
           {"Bip01 L Thigh", "Bip01 R Thigh"},
           {"left_hip", "right_hip"},
           {"hip left", "hip right"},
           {"LEFT_HIP", "RIGHT_HIP"},
           {"leg_joint_L_1", "leg_joint_R_1"},
           {"IKHandL", "IKHandR"},
           {"finger1l", "finger1r"}}) {
    EXPECT_EQ(OtherSideNames(left).front(), right);
    EXPECT_EQ(OtherSideNames(right).front(), left);
    EXPECT_EQ(SideNamed(left), BodySide::kLeft) << left;
    EXPECT_EQ(SideNamed(right), BodySide::kRight) << right;
  }
}

TEST(SideNames, ALetterWithinAWordIsNoSide) {
  for (const char* name : {"lower_leg", "relax", "LowerBack", "Roll", "upright", "clavicle", "rib",
                           "Head", "lfemur", "leftover", "", "L_to_R"}) {
    EXPECT_EQ(SideNamed(name), BodySide::kMiddle) << name;
  }
}

// What is guessed comes last: only a figure that has the other one too makes it a side.
TEST(SideNames, BeginningsOfWordsAreTried) {
  EXPECT_EQ(OtherSideNames("lfemur"), (std::vector<std::string>{"rfemur"}));
  EXPECT_EQ(OtherSideNames("rightfoot").front(), "leftfoot");
  EXPECT_TRUE(OtherSideNames("Head").empty());
  EXPECT_TRUE(OtherSideNames("spine_2").empty());
}

TEST(SideNames, OfTwoSidesAllAreExchangedFirstThenEach) {
  const std::vector<std::string> others = OtherSideNames("Left_arm_L");
  EXPECT_EQ(others[0], "Right_arm_R");
  EXPECT_EQ(std::set<std::string>(others.begin() + 1, others.begin() + 3),
            (std::set<std::string>{"Left_arm_R", "Right_arm_L"}));
}

}  // namespace
}  // namespace hazumi::test
