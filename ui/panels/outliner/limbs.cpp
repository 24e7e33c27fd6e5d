#include "ui/panels/outliner/limbs.h"

#include <utility>

#include "engine/body/figure_body.h"
#include "engine/figure/sides.h"

namespace hazumi::ui {

namespace {

// Of the limb whose first joint with a role has this one; empty: it has no word.
std::string PartOf(BodyRole role, bool has_four_legs) {
  switch (role) {
    case BodyRole::kClavicle:
    case BodyRole::kUpperArm:
    case BodyRole::kForearm:
    case BodyRole::kHand:
      return has_four_legs ? "front leg" : "arm";
    case BodyRole::kThigh:
    case BodyRole::kShin:
    case BodyRole::kFoot:
      return has_four_legs ? "hind leg" : "leg";
    case BodyRole::kNeck:
    case BodyRole::kHead:
      return "head";
    case BodyRole::kHips:
    case BodyRole::kSpine:
      return "torso";
    default:
      return "";
  }
}

const char* WordOf(BodySide side) {
  if (side == BodySide::kMiddle) return "";
  return side == BodySide::kLeft ? "left " : "right ";
}

std::string NameOfLimb(const Figure& figure, const FigureBody& body, bool has_four_legs,
                       const FigureSides& sides, const std::vector<GroupIndex>& joints) {
  const std::string& first = figure.group(joints.front()).name;
  std::string part;
  for (size_t i = 0; part.empty() && i < joints.size(); ++i) {
    part = PartOf(body.PlaceOf(joints[i]).role, has_four_legs);
  }
  if (part.empty()) {
    const std::string& last = figure.group(joints.back()).name;
    return joints.size() == 1 ? first : first + " - " + last;
  }
  std::string name = WordOf(sides.SideOf(joints.front())) + part;
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

}  // namespace

std::vector<JointIndex> HingesOf(const Figure& figure, GroupIndex joint) {
  const JointGroup& group = figure.group(joint);
  std::vector<JointIndex> hinges;
  for (int j = group.first.value(); j <= group.last().value(); ++j) hinges.emplace_back(j);
  return hinges;
}

std::vector<Limb> LimbsOf(const Figure& figure) {
  const int num = static_cast<int>(figure.groups().size());
  std::vector<int> parent(num, -1), num_children(num, 0), limb_of(num, -1);
  for (int g = 0; g < num; ++g) {
    const JointIndex before = figure.joint(figure.groups()[g].first).parent;
    if (before.is_valid()) parent[g] = figure.joint(before).group.value();
    if (parent[g] >= 0) ++num_children[parent[g]];
  }
  std::vector<Limb> limbs;
  for (int g = 0; g < num; ++g) {
    if (parent[g] >= 0 && num_children[parent[g]] == 1) {
      limb_of[g] = limb_of[parent[g]];
    } else {
      limb_of[g] = static_cast<int>(limbs.size());
      limbs.emplace_back();
    }
    limbs[limb_of[g]].joints.emplace_back(g);
    limbs[limb_of[g]].is_end = num_children[g] == 0;
  }
  const FigureBody body(figure);
  const bool has_four_legs = body.HasFourLegs();
  const FigureSides sides(figure);
  for (Limb& limb : limbs) limb.name = NameOfLimb(figure, body, has_four_legs, sides, limb.joints);
  return limbs;
}

}  // namespace hazumi::ui
