#include "ui/edit/operators/limb_chain.h"

#include "ui/edit/operators/at_frame.h"

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

}  // namespace hazumi::edit
