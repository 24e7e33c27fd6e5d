#pragma once

#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/jet.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

template <typename T>
using VecXOf = Eigen::Matrix<T, Eigen::Dynamic, 1>;

// What a chain looks like at some angles, world axes. By row of the unknown hinges: the axis, and
// the velocity that a unit rate gives the held joint's origin [m/rad].
template <typename T>
struct ChainPose {
  std::vector<Vec3Of<T>> axis, origin, J;
  Vec3Of<T> p;  // held joint's origin [m]
  Mat3Of<T> R;  // body it sits on

  explicit ChainPose(int rows) : axis(rows), origin(rows), J(rows) {}
};

// The hinges between the root and a held joint, the latter's own left out. Those of the `solved`
// joints that are not fixed are the unknowns of inverse kinematics.
class HoldChain {
 public:
  HoldChain(const Figure& figure, GroupIndex held, const std::vector<GroupIndex>& solved);

  const std::vector<JointIndex>& unknowns() const { return unknowns_; }
  int size() const { return static_cast<int>(unknowns_.size()); }
  // From the root, those that are fixed as well.
  template <typename Action>
  void ForEachJoint(Action&& action) const {
    for (const Hinge& hinge : hinges_) action(hinge.joint);
  }
  // Unknown number `row`.
  const Joint& joint(int row) const { return figure_->joint(unknowns_[row]); }

  // The chain with its root at X_WR, the unknown angles from the head of x and the others from q
  // (by JointIndex). T is double or Jet.
  template <typename T>
  void Place(const PoseOf<Jet>& X_WR, const std::vector<Jet>& q, const VecXOf<T>& x,
             ChainPose<T>* pose) const;

 private:
  struct Hinge {
    JointIndex joint;
    int row;  // in unknowns_, or -1
  };
  const Figure* figure_;
  JointIndex held_;
  std::vector<Hinge> hinges_;  // from the root
  std::vector<JointIndex> unknowns_;
};

}  // namespace hazumi
