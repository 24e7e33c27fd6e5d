#include "engine/makers/carried_body.h"

namespace hazumi::makers {

RigidInertia CarriedBody(JointIndex hinge, JointIndex next, const Figure& figure,
                         const DynamicsWorkspace& ws) {
  const Pose X_JW = Pose{ws.body(hinge).R, ws.body(hinge).p}.Inverse();
  RigidInertia sum;
  for (int j = hinge.value(); j < figure.joint(hinge).subtree_end.value(); ++j) {
    const RigidInertia& own = figure.body(JointIndex(j));
    if (own.is_massless() || (next.is_valid() && figure.IsBeyond(JointIndex(j), next))) continue;
    const BodyScratch& body = ws.body(JointIndex(j));
    sum = Combine(sum, Moved(own, X_JW * Pose{body.R, body.p}));
  }
  return sum;
}

}  // namespace hazumi::makers
