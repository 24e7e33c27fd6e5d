#include <gtest/gtest.h>

#include "engine/body/body_names.h"
#include "engine/exchange/import/segment_table.h"

namespace hazumi::test {
namespace {

using enum BodyPart;
using enum BodySide;

struct Row {
  const char* bone;
  BodyPart part;
  BodySide side;
  BodyWord word = BodyWord::kClear;
};

using enum BodyWord;

const Row kRows[] = {
    // Mixamo, MotionBuilder and the CMU clips made with it
    {"mixamorig:Hips", kPelvis, kMiddle},
    {"mixamorig:LeftForeArm", kForearm, kLeft},
    {"mixamorig:RightUpLeg", kThigh, kRight},
    {"mixamorig:RightLeg", kShank, kRight, kLeg},
    {"mixamorig:LeftToeBase", kFoot, kLeft},
    {"mixamorig:LeftHandIndex1", kHand, kLeft},
    {"mixamorig:HeadTop_End", kHead, kMiddle},
    {"Hips", kPelvis, kMiddle},
    {"LHipJoint", kPelvis, kLeft},
    {"LeftUpLeg", kThigh, kLeft},
    {"LeftLeg", kShank, kLeft, kLeg},
    {"LowerBack", kTrunk, kMiddle},
    {"Spine1", kTrunk, kMiddle},
    {"Neck1", kNeck, kMiddle},
    {"Head", kHead, kMiddle},
    {"LeftShoulder", kTrunk, kLeft, kShoulder},
    {"LeftArm", kUpperArm, kLeft, kArm},
    {"LThumb", kHand, kLeft},
    {"RightFingerBase", kHand, kRight},
    {"LeftHandEnd", kHand, kLeft},
    // Names of joints
    {"LeftHip", kThigh, kLeft, kHip},
    {"LeftKnee", kShank, kLeft},
    {"LeftAnkle", kFoot, kLeft},
    {"RightElbow", kForearm, kRight},
    {"RightWrist", kHand, kRight},
    // Acclaim
    {"lfemur", kThigh, kLeft},
    {"rtibia", kShank, kRight},
    {"lhumerus", kUpperArm, kLeft},
    {"rradius", kForearm, kRight},
    {"lclavicle", kTrunk, kLeft},
    {"rwrist", kHand, kRight},
    {"lhipjoint", kPelvis, kLeft},
    {"ltoes", kFoot, kLeft},
    // Unreal
    {"pelvis", kPelvis, kMiddle},
    {"spine_02", kTrunk, kMiddle},
    {"clavicle_r", kTrunk, kRight},
    {"upperarm_l", kUpperArm, kLeft},
    {"lowerarm_l", kForearm, kLeft},
    {"hand_r", kHand, kRight},
    {"thigh_l", kThigh, kLeft},
    {"calf_r", kShank, kRight},
    {"ball_l", kFoot, kLeft},
    {"neck_01", kNeck, kMiddle},
    // Rigify
    {"DEF-forearm.L", kForearm, kLeft},
    {"DEF-upper_arm.R", kUpperArm, kRight},
    {"DEF-thigh.L.001", kThigh, kLeft},
    {"DEF-shin.R", kShank, kRight},
    {"DEF-spine.003", kTrunk, kMiddle},
    {"DEF-f_index.01.L", kHand, kLeft},
    // Daz and Poser
    {"hip", kPelvis, kMiddle},
    {"abdomen", kTrunk, kMiddle},
    {"lCollar", kTrunk, kLeft},
    {"lShldr", kUpperArm, kLeft},
    {"rForeArm", kForearm, kRight},
    {"rHand", kHand, kRight},
    {"rThigh", kThigh, kRight},
    {"lShin", kShank, kLeft},
    {"lFoot", kFoot, kLeft},
    {"rThighBend", kThigh, kRight},
    {"lEye", kHead, kLeft},
    // KayKit
    {"upperleg.l", kThigh, kLeft},
    {"lowerleg.r", kShank, kRight},
    {"wrist.l", kHand, kLeft},
    {"chest", kTrunk, kMiddle},
    // 3ds Max
    {"Bip01 L UpperArm", kUpperArm, kLeft},
    {"Bip01 R Calf", kShank, kRight},
    {"Bip01 Pelvis", kPelvis, kMiddle},
    // Nothing of a body
    {"Armature", kOther, kMiddle},
    {"root", kOther, kMiddle},
    {"Bone.001", kOther, kMiddle},
};

TEST(BodyNames, AreReadInTheSpellingOfCommonRigs) {
  for (const Row& row : kRows) {
    const ReadName name = ReadBoneName(row.bone);
    EXPECT_EQ(static_cast<int>(name.body.part), static_cast<int>(row.part)) << row.bone;
    EXPECT_EQ(static_cast<int>(name.body.side), static_cast<int>(row.side)) << row.bone;
    EXPECT_EQ(static_cast<int>(name.word), static_cast<int>(row.word)) << row.bone;
  }
}

// Each bone hangs on the one before it.
void ExpectChain(const std::vector<std::pair<std::string, BodyPart>>& chain) {
  std::vector<NamedBone> bones;
  for (const auto& [name, part] : chain) {
    bones.push_back({name, static_cast<int>(bones.size()) - 1});
  }
  const std::vector<BodyName> told = BonesInBody(bones);
  for (size_t b = 0; b < chain.size(); ++b) {
    EXPECT_EQ(static_cast<int>(told[b].part), static_cast<int>(chain[b].second)) << chain[b].first;
  }
}

TEST(BodyNames, WordsThatAreNotClearAreToldByTheBonesBesideThem) {
  ExpectChain({{"Chest", kTrunk}, {"LeftShoulder", kTrunk}, {"LeftArm", kUpperArm}});
  ExpectChain({{"Chest", kTrunk},
               {"LeftCollar", kTrunk},
               {"LeftShoulder", kUpperArm},
               {"LeftElbow", kForearm},
               {"LeftWrist", kHand}});
  ExpectChain({{"shoulder.L", kTrunk}, {"upper_arm.L", kUpperArm}, {"forearm.L", kForearm}});
  ExpectChain({{"Hips", kPelvis}, {"LeftHip", kThigh}, {"LeftKnee", kShank}});
  ExpectChain({{"Hips", kPelvis},
               {"LeftHip", kPelvis},
               {"LeftUpLeg", kThigh},
               {"LeftLeg", kShank},
               {"LeftLegRoll", kShank},
               {"LeftFoot", kFoot}});
  ExpectChain({{"Hips", kPelvis}, {"LeftLeg", kThigh}, {"LeftKnee", kShank}});
  ExpectChain({{"leg_L_1", kThigh}, {"leg_L_2", kShank}, {"leg_L_3", kFoot}, {"leg_L_5", kFoot}});
  ExpectChain({{"arm_R_1", kUpperArm}, {"arm_R_2", kForearm}, {"hand_R", kHand}, {"sword", kHand}});
  ExpectChain({{"LeftArm", kUpperArm}, {"LeftArmRoll", kUpperArm}, {"LeftForeArm", kForearm}});
}

TEST(BodyNames, WhatAllNamesBeginWithSaysNothing) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(WithoutPrefix({"Armature_Hips", "Armature_LeftArm"}), (Names{"Hips", "LeftArm"}));
  EXPECT_EQ(WithoutPrefix({"Hero|a_b", "Hero|a_c"}), (Names{"b", "c"}));
  EXPECT_EQ(WithoutPrefix({"Armature", "Armature_Hips"}), (Names{"Armature", "Armature_Hips"}));
  EXPECT_EQ(WithoutPrefix({"Left_Arm", "Left_Hand"}), (Names{"Left_Arm", "Left_Hand"}));
  EXPECT_EQ(WithoutPrefix({"Hips", "Head"}), (Names{"Hips", "Head"})) << "no separator";
  EXPECT_EQ(WithoutPrefix({"root"}), (Names{"root"}));
  ExpectChain({{"Armature_Chest", kTrunk},
               {"Armature_LeftArm", kUpperArm},
               {"Armature_LeftForeArm", kForearm}});
  EXPECT_FALSE(ReadBoneName("control_LeftLeg").is_twist) << "no \"roll\" in it";
}

TEST(BodyNames, WordsOfLimbsOnNoSideAreNoLimbs) {
  ExpectChain({{"Hips", kPelvis}, {"Bip01 Footsteps", kOther}, {"LeftUpLeg", kThigh}});
  ExpectChain({{"LeftUpLeg", kThigh}, {"LeftFoot", kFoot}, {"LeftFootThumb1", kFoot}});
}

TEST(BodyNames, AreThoseOfABodyOnlyWithATrunkOrHeadAndALimb) {
  const auto is_body = [](const std::vector<NamedBone>& bones) {
    return IsBody(BonesInBody(bones));
  };
  EXPECT_TRUE(is_body({{"Hips", -1}, {"LeftUpLeg", 0}}));
  EXPECT_FALSE(is_body({{"base", -1}, {"arm_l0", 0}, {"forearm", 1}, {"wrist", 2}}));
  EXPECT_FALSE(is_body({{"Spine", -1}, {"Spine1", 0}, {"Head", 1}}));
  EXPECT_FALSE(is_body({{"LeftShoulder", -1}, {"LeftArm", 0}, {"LeftForeArm", 1}}));
}

TEST(SegmentTable, SharesOfOnePersonAddUpToOne) {
  double sum = 0.0;
  for (int i = 0; i < kNumRows; ++i) {
    const auto row = static_cast<BodySegment>(i);
    sum += (IsLimb(row) ? 2.0 : 1.0) * RowOf(row).mass;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

}  // namespace
}  // namespace hazumi::test
