#include "ui/edit/operators/pose/limb_chain.h"

#include <algorithm>

#include "ui/edit/operators/keys/at_frame.h"

namespace hazumi::edit {

std::vector<JointIndex> KeyedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation) {
  std::vector<JointIndex> hinges;
  for (const GroupIndex g : joints) {
    const JointGroup& group = animation.figure->group(g);
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      const JointIndex hinge(j);
      const bool is_keyed =
          !animation.figure->joint(hinge).is_fixed() && !IsSwung(animation, hinge, frame);
      if (is_keyed) hinges.push_back(hinge);
    }
  }
  return hinges;
}

std::vector<JointIndex> PosedHinges(const std::vector<GroupIndex>& joints, double frame,
                                    const Animation& animation,
                                    const std::set<std::string>& locked) {
  std::vector<JointIndex> hinges = KeyedHinges(joints, frame, animation);
  std::erase_if(hinges,
                [&](JointIndex j) { return locked.contains(animation.figure->joint(j).name); });
  return hinges;
}

bool EndsLimb(GroupIndex joint, const Figure& figure) {
  const std::vector<GroupIndex> carriers = ChainOf(joint, 2, figure);
  return carriers.size() == 2 && std::all_of(carriers.begin(), carriers.end(), [&](GroupIndex g) {
           return ChildrenOf(figure.group(g).last(), figure).size() == 1;
         });
}

bool IsFoot(GroupIndex joint, const Figure& figure) {
  const std::vector<GroupIndex> chain = ChainOf(joint, std::nullopt, figure);
  return EndsLimb(joint, figure) &&
         !figure.joint(figure.group(chain.back()).first).parent.is_valid();
}

}  // namespace hazumi::edit
