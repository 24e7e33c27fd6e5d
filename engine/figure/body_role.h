#pragma once

// What a joint is in a body: of people, of animals on two or four legs. A joint is called what the
// body beyond it is: the shoulder joint is that of the upper arm.

#include "engine/figure/side_names.h"

namespace hazumi {

enum class BodyRole {
  kNone,  // nothing that has a word here
  kHips,
  kSpine,
  kNeck,
  kHead,
  kClavicle,
  kUpperArm,  // the upper part of a front leg, too
  kForearm,
  kHand,
  kFinger,
  kThigh,
  kShin,
  kFoot,
  kToe,
  kTail,
  kWing,
  kEar,
  kWeapon,  // what a hand holds, or the place for it
  kTwist,   // a part of the bone that it hangs on
  kCloth,   // and hair
  kHelper,  // of a rig: moves others, or is moved for nothing
};
inline constexpr int kNumBodyRoles = static_cast<int>(BodyRole::kHelper) + 1;

constexpr const char* NameOf(BodyRole role) {
  constexpr const char* kNames[kNumBodyRoles] = {
      "none",    "hips", "spine",  "neck",   "head",  "clavicle", "upper_arm",
      "forearm", "hand", "finger", "thigh",  "shin",  "foot",     "toe",
      "tail",    "wing", "ear",    "weapon", "twist", "cloth",    "helper"};
  return kNames[static_cast<int>(role)];
}

// Whether a body has one of it on the left and one on the right, or several.
constexpr bool NeedsSide(BodyRole role) {
  return role >= BodyRole::kClavicle && role <= BodyRole::kToe;
}
constexpr bool MayHaveSide(BodyRole role) {
  return NeedsSide(role) || role == BodyRole::kWing || role == BodyRole::kEar ||
         role == BodyRole::kWeapon || role == BodyRole::kTwist;
}
// Whether a body has it once, or once on each side.
constexpr bool IsSingle(BodyRole role) {
  return role == BodyRole::kHips || role == BodyRole::kHead ||
         (NeedsSide(role) && role != BodyRole::kFinger);
}

constexpr const char* NameOf(BodySide side) {
  if (side == BodySide::kMiddle) return "middle";
  return side == BodySide::kLeft ? "left" : "right";
}

struct BodyPlace {
  BodyRole role = BodyRole::kNone;
  BodySide side = BodySide::kMiddle;
  bool operator==(const BodyPlace&) const = default;
};

}  // namespace hazumi
