#include "engine/exchange/import/body_part.h"

#include <gtest/gtest.h>

namespace hazumi::test {
namespace {

using enum BodyPart;
using enum BodySide;

struct Row {
  const char* bone;
  BodyPart part;
  BodySide side;
  Naming naming = Naming::kByBone;
};

constexpr Naming kByJoint = Naming::kByJoint;

const Row kRows[] = {
    // Mixamo, MotionBuilder and the CMU clips made with it
    {"mixamorig:Hips", kPelvis, kMiddle},
    {"mixamorig:LeftForeArm", kForearm, kLeft},
    {"mixamorig:RightUpLeg", kThigh, kRight},
    {"mixamorig:RightLeg", kShank, kRight},
    {"mixamorig:LeftToeBase", kFoot, kLeft},
    {"mixamorig:LeftHandIndex1", kHand, kLeft},
    {"mixamorig:HeadTop_End", kHead, kMiddle},
    {"Hips", kPelvis, kMiddle},
    {"LHipJoint", kPelvis, kLeft},
    {"LeftUpLeg", kThigh, kLeft},
    {"LeftLeg", kShank, kLeft},
    {"LowerBack", kTrunk, kMiddle},
    {"Spine1", kTrunk, kMiddle},
    {"Neck1", kNeck, kMiddle},
    {"Head", kHead, kMiddle},
    {"LeftShoulder", kTrunk, kLeft},
    {"LeftArm", kUpperArm, kLeft},
    {"LThumb", kHand, kLeft},
    {"RightFingerBase", kHand, kRight},
    {"LeftHandEnd", kHand, kLeft},
    // Names of joints
    {"LeftHip", kThigh, kLeft, kByJoint},
    {"LeftKnee", kShank, kLeft, kByJoint},
    {"LeftAnkle", kFoot, kLeft, kByJoint},
    {"RightShoulder", kUpperArm, kRight, kByJoint},
    {"RightElbow", kForearm, kRight, kByJoint},
    {"RightWrist", kHand, kRight, kByJoint},
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
    const BodyName name = BodyNameOf(row.bone, row.naming);
    EXPECT_EQ(static_cast<int>(name.part), static_cast<int>(row.part)) << row.bone;
    EXPECT_EQ(static_cast<int>(name.side), static_cast<int>(row.side)) << row.bone;
  }
}

TEST(BodyNames, SharesOfOnePersonAddUpToOne) {
  double sum = 0.0;
  for (int i = 0; i < kNumBodyParts; ++i) {
    const auto part = static_cast<BodyPart>(i);
    const bool is_pair = part == kUpperArm || part == kForearm || part == kHand || part == kThigh ||
                         part == kShank || part == kFoot;
    sum += (is_pair ? 2.0 : 1.0) * MassShareOf(part);
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

}  // namespace
}  // namespace hazumi::test
