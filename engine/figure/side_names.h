#pragma once

// What names say of left and right, in the spelling of any common rig: "l_elbow", "upperarm.l",
// "LeftArm", "mixamorig:LeftForeArm", "Bip01 L Thigh", "lThigh", "LHipJoint", "lfemur".

#include <string>
#include <vector>

namespace hazumi {

enum class BodySide { kMiddle, kLeft, kRight };

inline BodySide OtherSide(BodySide side) {
  if (side == BodySide::kMiddle) return side;
  return side == BodySide::kLeft ? BodySide::kRight : BodySide::kLeft;
}

// By a word of its own: left, right, l or r, between separators, digits or the humps of camel case.
// kMiddle if there is none, or if there are both.
BodySide SideNamed(const std::string& name);

// What the same thing on the other side may be called, the likeliest first. "lower" is among those
// of "rower": what counts is what else there is.
std::vector<std::string> OtherSideNames(const std::string& name);

}  // namespace hazumi
