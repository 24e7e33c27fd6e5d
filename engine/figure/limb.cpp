#include "engine/figure/limb.h"

namespace hazumi {

std::vector<GroupIndex> ChildrenOf(JointIndex body, const Figure& figure) {
  std::vector<GroupIndex> children;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    if (figure.joint(figure.groups()[g].first).parent == body) children.emplace_back(g);
  }
  return children;
}

std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure) {
  std::vector<GroupIndex> joints;
  for (JointIndex j = figure.joint(figure.group(moved).first).parent; j.is_valid();) {
    const GroupIndex group = figure.joint(j).group;
    if (count && *count > 0 && static_cast<int>(joints.size()) == *count) break;
    if (!count && !joints.empty() && ChildrenOf(figure.group(group).last(), figure).size() > 1)
      break;
    joints.push_back(group);
    j = figure.joint(figure.group(group).first).parent;
  }
  return joints;
}

}  // namespace hazumi
