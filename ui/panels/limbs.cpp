#include "ui/panels/limbs.h"

#include <utility>

namespace hazumi::ui {

namespace {

bool NamesOneOf(const std::string& joint, std::initializer_list<const char*> words) {
  for (const char* word : words) {
    if (joint.find(word) != std::string::npos) return true;
  }
  return false;
}

// The part of the body that a joint's name tells, in lower case; empty if none.
std::string PartOf(const std::string& joint) {
  if (NamesOneOf(joint, {"shoulder", "elbow", "arm", "wrist", "clavicle"})) return "arm";
  if (NamesOneOf(joint, {"hip", "knee", "leg", "thigh", "ankle", "shin"})) return "leg";
  if (NamesOneOf(joint, {"neck", "head", "skull"})) return "head";
  if (NamesOneOf(joint, {"waist", "chest", "spine", "torso", "abdomen", "trunk"})) return "torso";
  return "";
}

std::string SideOf(const std::string& joint) {
  if (joint.starts_with("r_") || joint.starts_with("right")) return "right ";
  if (joint.starts_with("l_") || joint.starts_with("left")) return "left ";
  return "";
}

std::string NameOfLimb(const Figure& figure, const std::vector<GroupIndex>& joints) {
  const std::string& first = figure.group(joints.front()).name;
  const std::string part = PartOf(first);
  if (part.empty()) {
    const std::string& last = figure.group(joints.back()).name;
    return joints.size() == 1 ? first : first + " - " + last;
  }
  std::string name = SideOf(first) + part;
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
  for (Limb& limb : limbs) limb.name = NameOfLimb(figure, limb.joints);
  return limbs;
}

}  // namespace hazumi::ui
