#pragma once

#include <string>
#include <vector>

#include "engine/figure/body_role.h"
#include "engine/figure/side_names.h"

namespace hazumi {

// Parts of a human body that have a name and a thickness.
enum class BodyPart {
  kPelvis,
  kTrunk,
  kNeck,
  kHead,
  kUpperArm,
  kForearm,
  kHand,
  kThigh,
  kShank,
  kFoot,
  kOther,
};
inline constexpr int kNumBodyParts = static_cast<int>(BodyPart::kOther) + 1;

struct BodyName {
  BodyPart part = BodyPart::kOther;
  BodySide side = BodySide::kMiddle;
  bool operator==(const BodyName&) const = default;
};

// Words that mean different bones in different rigs: body_names.h tells by the bones beside them.
enum class BodyWord {
  kClear,
  kHip,       // of a side: a thigh, or a hip joint above one
  kShoulder,  // a collar, or an upper arm
  kArm,       // an upper arm, or any bone of an arm
  kLeg,       // a shank, a thigh, or any bone of a leg
};

// Whether there is one on each side.
inline bool IsLimb(BodyPart part) { return part >= BodyPart::kUpperArm && part <= BodyPart::kFoot; }

// What a bone's name alone says, in the spelling of any common rig: "mixamorig:LeftForeArm",
// "l_forearm", "forearm.L", "Skeleton_arm_joint_L__3_". Of a word that is not clear: what it is in
// most rigs.
struct ReadName {
  BodyName body;
  BodyWord word = BodyWord::kClear;
  bool is_twist = false;   // a part of the bone above it: "LeftArmRoll"
  bool is_helper = false;  // of a rig, no part of a body: "ik_hand_l", "kneePole.L"
};
ReadName ReadBoneName(const std::string& bone);

// Letters of a name in lower case, in words: at anything else and where a capital follows a small
// letter a new one begins.
std::vector<std::string> WordsOfName(const std::string& name);

// Names without what all of them begin with up to a separator, such as "Armature_" or "Hero|",
// unless that is a side.
std::vector<std::string> WithoutPrefix(std::vector<std::string> names);

// Part of a body that has a role.
BodyPart PartOf(BodyRole role);

// Of a capsule, as a share of the body's height. Ours.
double RadiusShareOf(const BodyName& body);

}  // namespace hazumi
