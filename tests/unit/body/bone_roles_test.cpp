// Roles by names: of rigs as common programs write them.

#include "engine/body/bone_roles.h"

#include <gtest/gtest.h>

#include <map>

namespace hazumi::test {
namespace {

using enum BodyRole;

// A bone, what it hangs on, and what it is.
struct Row {
  const char* bone;
  const char* parent;
  BodyPlace place;
};

constexpr BodySide kL = BodySide::kLeft, kR = BodySide::kRight, kM = BodySide::kMiddle;

void ExpectRoles(const std::vector<Row>& rows) {
  std::map<std::string, int> index;
  std::vector<NamedBone> bones;
  for (const Row& row : rows) {
    const auto parent = index.find(row.parent);
    bones.push_back({row.bone, parent == index.end() ? -1 : parent->second});
    index[row.bone] = static_cast<int>(bones.size()) - 1;
  }
  const std::vector<BodyPlace> told = RolesByName(bones).places;
  for (size_t b = 0; b < rows.size(); ++b) {
    EXPECT_STREQ(NameOf(told[b].role), NameOf(rows[b].place.role)) << rows[b].bone;
    if (rows[b].place.role == kNone) continue;
    EXPECT_STREQ(NameOf(told[b].side), NameOf(rows[b].place.side)) << rows[b].bone;
  }
}

TEST(BoneRoles, OfMixamosRig) {
  ExpectRoles({{"mixamorig:Hips", "", {kHips, kM}},
               {"mixamorig:Spine", "mixamorig:Hips", {kSpine, kM}},
               {"mixamorig:Spine1", "mixamorig:Spine", {kSpine, kM}},
               {"mixamorig:Neck", "mixamorig:Spine1", {kNeck, kM}},
               {"mixamorig:Head", "mixamorig:Neck", {kHead, kM}},
               {"mixamorig:LeftShoulder", "mixamorig:Spine1", {kClavicle, kL}},
               {"mixamorig:LeftArm", "mixamorig:LeftShoulder", {kUpperArm, kL}},
               {"mixamorig:LeftForeArm", "mixamorig:LeftArm", {kForearm, kL}},
               {"mixamorig:LeftHand", "mixamorig:LeftForeArm", {kHand, kL}},
               {"mixamorig:LeftHandIndex1", "mixamorig:LeftHand", {kFinger, kL}},
               {"mixamorig:RightUpLeg", "mixamorig:Hips", {kThigh, kR}},
               {"mixamorig:RightLeg", "mixamorig:RightUpLeg", {kShin, kR}},
               {"mixamorig:RightFoot", "mixamorig:RightLeg", {kFoot, kR}},
               {"mixamorig:RightToeBase", "mixamorig:RightFoot", {kToe, kR}}});
}

TEST(BoneRoles, OfUnrealsRig) {
  ExpectRoles({{"root", "", {kNone, kM}},
               {"pelvis", "root", {kHips, kM}},
               {"spine_01", "pelvis", {kSpine, kM}},
               {"spine_02", "spine_01", {kSpine, kM}},
               {"clavicle_l", "spine_02", {kClavicle, kL}},
               {"upperarm_l", "clavicle_l", {kUpperArm, kL}},
               {"upperarm_twist_01_l", "upperarm_l", {kTwist, kL}},
               {"lowerarm_l", "upperarm_l", {kForearm, kL}},
               {"hand_l", "lowerarm_l", {kHand, kL}},
               {"thumb_01_l", "hand_l", {kFinger, kL}},
               {"neck_01", "spine_02", {kNeck, kM}},
               {"head", "neck_01", {kHead, kM}},
               {"thigh_r", "pelvis", {kThigh, kR}},
               {"calf_r", "thigh_r", {kShin, kR}},
               {"foot_r", "calf_r", {kFoot, kR}},
               {"ball_r", "foot_r", {kToe, kR}}});
}

TEST(BoneRoles, OfABipedWhoseLegsHangOnItsFirstSpine) {
  ExpectRoles({{"Bip01 Pelvis", "", {kHips, kM}},
               {"Bip01 Spine", "Bip01 Pelvis", {kNone, kM}},
               {"Bip01 L Thigh", "Bip01 Spine", {kThigh, kL}},
               {"Bip01 L Calf", "Bip01 L Thigh", {kShin, kL}},
               {"Bip01 Spine1", "Bip01 Spine", {kSpine, kM}},
               {"Bip01 Neck", "Bip01 Spine1", {kSpine, kM}},  // it carries the arms
               {"Bip01 Head", "Bip01 Neck", {kHead, kM}},
               {"Bip01 L Clavicle", "Bip01 Neck", {kClavicle, kL}},
               {"Bip01 L UpperArm", "Bip01 L Clavicle", {kUpperArm, kL}},
               {"Bip01 L Forearm", "Bip01 L UpperArm", {kForearm, kL}},
               {"Bip01 L Hand", "Bip01 L Forearm", {kHand, kL}}});
}

TEST(BoneRoles, OfTheHumanThatComesWithHazumi) {
  ExpectRoles({{"pelvis", "", {kHips, kM}},
               {"waist", "pelvis", {kSpine, kM}},
               {"chest", "waist", {kSpine, kM}},
               {"neck", "chest", {kNeck, kM}},
               {"r_shoulder", "chest", {kUpperArm, kR}},
               {"r_elbow", "r_shoulder", {kForearm, kR}},
               {"r_wrist", "r_elbow", {kHand, kR}},
               {"l_hip", "pelvis", {kThigh, kL}},
               {"l_knee", "l_hip", {kShin, kL}},
               {"l_ankle", "l_knee", {kFoot, kL}},
               {"l_toe", "l_ankle", {kToe, kL}}});
}

TEST(BoneRoles, TheSpineIsWhatLiesBetweenWhateverItIsCalled) {
  ExpectRoles({{"butt_bone", "", {kHips, kM}},
               {"body_IK", "butt_bone", {kHelper, kM}},
               {"arm_upper.L", "body_IK", {kUpperArm, kL}},
               {"arm_lower.L", "arm_upper.L", {kForearm, kL}},
               {"body_lower", "butt_bone", {kSpine, kM}},
               {"body_upper", "body_lower", {kSpine, kM}},
               {"head", "body_upper", {kHead, kM}},
               {"leg_upper.L", "butt_bone", {kThigh, kL}},
               {"leg_lower.L", "leg_upper.L", {kShin, kL}}});
}

TEST(BoneRoles, OfWhatHangsOnABody) {
  ExpectRoles({{"hips", "", {kHips, kM}},
               {"chest", "hips", {kSpine, kM}},
               {"head", "chest", {kHead, kM}},
               {"hair_01", "head", {kCloth, kM}},
               {"ear.l", "head", {kEar, kL}},
               {"cape", "chest", {kCloth, kM}},
               {"upperarm.l", "chest", {kUpperArm, kL}},
               {"lowerarm.l", "upperarm.l", {kForearm, kL}},
               {"wrist.l", "lowerarm.l", {kHand, kL}},
               {"hand.l", "wrist.l", {kNone, kL}},
               {"handslot.l", "hand.l", {kWeapon, kL}},
               {"tail", "hips", {kTail, kM}}});
}

TEST(BoneRoles, FrontLegsAreArms) {
  const std::vector<NamedBone> bones = {{"Body", -1},           {"Head", 0},
                                        {"FrontUpperLeg.L", 0}, {"FrontLowerLeg.L", 2},
                                        {"BackUpperLeg.L", 0},  {"BackLowerLeg.L", 4}};
  const BoneRoles roles = RolesByName(bones);
  EXPECT_TRUE(roles.has_four_legs);
  EXPECT_EQ(roles.places[2], (BodyPlace{kUpperArm, kL}));
  EXPECT_EQ(roles.places[3], (BodyPlace{kForearm, kL}));
  EXPECT_EQ(roles.places[4], (BodyPlace{kThigh, kL}));
  EXPECT_EQ(roles.places[5], (BodyPlace{kShin, kL}));
}

TEST(BoneRoles, OfNoBody) {
  for (const BodyPlace& place :
       RolesByName({{"base", -1}, {"arm_l0", 0}, {"forearm", 1}, {"wrist", 2}}).places) {
    EXPECT_EQ(place, BodyPlace());
  }
}

}  // namespace
}  // namespace hazumi::test
