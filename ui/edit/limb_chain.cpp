#include "ui/edit/limb_chain.h"

#include <algorithm>

namespace hazumi::edit {

namespace {

int NumChildren(GroupIndex joint, const Figure& figure) {
  return static_cast<int>(
      std::count_if(figure.groups().begin(), figure.groups().end(), [&](const JointGroup& g) {
        return figure.joint(g.first).parent == figure.group(joint).last();
      }));
}

bool IsKeyed(JointIndex hinge, double frame, const Animation& animation) {
  if (animation.figure->joint(hinge).is_fixed()) return false;
  return std::none_of(
      animation.regions.begin(), animation.regions.end(), [&](const DynamicsRegion& region) {
        return frame > region.first_frame && frame <= region.last_frame &&
               std::binary_search(region.joints.begin(), region.joints.end(), hinge);
      });
}

}  // namespace

std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure) {
  std::vector<GroupIndex> joints;
  for (JointIndex j = figure.joint(figure.group(moved).first).parent; j.is_valid();) {
    const GroupIndex group = figure.joint(j).group;
    if (count && *count > 0 && static_cast<int>(joints.size()) == *count) break;
    if (!count && !joints.empty() && NumChildren(group, figure) > 1) break;
    joints.push_back(group);
    j = figure.joint(figure.group(group).first).parent;
  }
  return joints;
}

std::vector<JointIndex> KeyedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation) {
  std::vector<JointIndex> hinges;
  for (const GroupIndex g : joints) {
    const JointGroup& group = animation.figure->group(g);
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      if (IsKeyed(JointIndex(j), frame, animation)) hinges.push_back(JointIndex(j));
    }
  }
  return hinges;
}

}  // namespace hazumi::edit
