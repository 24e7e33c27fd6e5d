#include "engine/makers/throws/throw_poses.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/spatial/degrees.h"

namespace hazumi::makers {

std::vector<NamedThrowHinge> HingesOfThrow(BodySide side, const Figure& figure) {
  const std::string own = side == BodySide::kRight ? "r_" : "l_";
  const std::string other = side == BodySide::kRight ? "l_" : "r_";
  const FigureBody body(figure);
  std::vector<NamedThrowHinge> all;
  for (const ThrowHinge& hinge : kThrowHinges) {
    std::vector<std::string> sides = {own};
    if (hinge.limb == ThrowLimb::kTrunk) sides = {""};
    if (hinge.limb == ThrowLimb::kOtherArm) sides = {other};
    if (hinge.limb == ThrowLimb::kLegs) sides = {own, other};
    for (const std::string& of : sides) {
      for (const HingeShare& share : body.HingesFor(of + hinge.name)) {
        AddShare(share, hinge, figure, &all);
      }
    }
  }
  return all;
}

std::vector<ReleaseHabit> HabitsOf(ThrowStyle style, JointIndex joint, const Figure& figure) {
  constexpr double kLeastEase = 0.5;  // [rad/s]
  std::vector<ReleaseHabit> habits(static_cast<size_t>(figure.num_joints()));
  const auto side = SideOfHand(figure.group(figure.joint(joint).group).name, figure);
  if (!side) return habits;
  for (const NamedThrowHinge& of : HingesOfThrow(*side, figure)) {
    if (of.hinge.limb != ThrowLimb::kThrowingArm) continue;
    habits[static_cast<size_t>(of.joint.value())] = {
        of.hinge.At(style)[kRelease] * kDegree,
        std::max(kLeastEase, std::abs(of.hinge.EaseAt(style)))};
  }
  return habits;
}

// A forearm without a hand ends in it.
std::optional<GroupIndex> HandOf(const FigureBody& body, BodySide side) {
  const std::optional<GroupIndex> hand = body.Find(BodyRole::kHand, side);
  return hand ? hand : body.Find(BodyRole::kForearm, side);
}

std::optional<BodySide> SideOfHand(const std::string& holder, const Figure& figure) {
  const std::optional<GroupIndex> joint = figure.FindGroup(holder);
  const FigureBody body(figure);
  for (const BodySide side : {BodySide::kRight, BodySide::kLeft}) {
    const std::optional<GroupIndex> end = HandOf(body, side);
    const bool is_of_hand =
        joint && end && figure.IsBeyond(figure.group(*joint).first, figure.group(*end).first);
    if (is_of_hand &&
        body.HingeFor((side == BodySide::kRight ? "r_" : "l_") + std::string("shoulder_flexion"))) {
      return side;
    }
  }
  return std::nullopt;
}

}  // namespace hazumi::makers
