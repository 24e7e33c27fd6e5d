#pragma once

#include <string>

#include "engine/figure/side_names.h"

namespace hazumi {

// Parts of a human body that have a share of its mass and a thickness.
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

// Which bones a "shoulder" or a "hip" are depends on the others: in a skeleton with elbows and
// knees bones are called by the joint where they begin, else "LeftShoulder" is a collar bone.
enum class Naming { kByBone, kByJoint };

// What a bone's name says that it is, in the spelling of any common rig: "mixamorig:LeftForeArm",
// "l_forearm", "forearm.L", "Skeleton_arm_joint_L__3_".
BodyName BodyNameOf(const std::string& bone, Naming naming);

// The share of the whole body's mass of one such part: of one arm, of one leg. [de Leva 1996, male]
// 0 for kOther.
double MassShareOf(BodyPart part);
// From the part's near end to its centre of mass, as a share of its length [de Leva 1996, male].
double ComShareOf(BodyPart part);
// Of a capsule, as a share of the body's height. Ours.
double RadiusShareOf(BodyPart part);

}  // namespace hazumi
