#include "engine/placement/hold_chain.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

namespace {

template <typename T>
T As(const Jet& jet);
template <>
double As<double>(const Jet& jet) {
  return jet.v;
}
template <>
Jet As<Jet>(const Jet& jet) {
  return jet;
}

}  // namespace

HoldChain::HoldChain(const Figure& figure, GroupIndex held, const std::vector<GroupIndex>& solved)
    : figure_(&figure), held_(figure.group(held).first) {
  for (JointIndex j = figure.joint(held_).parent; j.is_valid(); j = figure.joint(j).parent) {
    hinges_.push_back({j, -1});
  }
  std::reverse(hinges_.begin(), hinges_.end());
  for (Hinge& hinge : hinges_) {
    const Joint& joint = figure.joint(hinge.joint);
    const bool is_solved = std::find(solved.begin(), solved.end(), joint.group) != solved.end();
    if (joint.is_fixed() || !is_solved) continue;
    hinge.row = size();
    unknowns_.push_back(hinge.joint);
  }
}

template <typename T>
void HoldChain::Place(const PoseOf<Jet>& X_WR, const std::vector<Jet>& q, const VecXOf<T>& x,
                      ChainPose<T>* pose) const {
  using std::cos, std::sin;
  pose->R = X_WR.R.unaryExpr(&As<T>);
  pose->p = X_WR.p.unaryExpr(&As<T>);
  for (const Hinge& hinge : hinges_) {
    const Joint& joint = figure_->joint(hinge.joint);
    const T angle = hinge.row >= 0 ? x[hinge.row] : As<T>(q[hinge.joint.value()]);
    pose->p += pose->R * joint.X_PJ.p.cast<T>();
    if (!joint.parallel_frame) pose->R = (pose->R * joint.X_PJ.R.cast<T>()).eval();
    if (hinge.row >= 0) {  // the axis is the same before and after the turn
      pose->axis[hinge.row] = pose->R * joint.axis.cast<T>();
      pose->origin[hinge.row] = pose->p;
    }
    Turn<T>(joint.axis, sin(angle), cos(angle), &pose->R);
  }
  pose->p += pose->R * figure_->joint(held_).X_PJ.p.cast<T>();
  for (int r = 0; r < size(); ++r) {
    pose->J[r] = pose->axis[r].cross(pose->p - pose->origin[r]);
  }
}

template void HoldChain::Place<double>(const PoseOf<Jet>&, const std::vector<Jet>&, const VecX&,
                                       ChainPose<double>*) const;
template void HoldChain::Place<Jet>(const PoseOf<Jet>&, const std::vector<Jet>&, const VecXOf<Jet>&,
                                    ChainPose<Jet>*) const;

}  // namespace hazumi
