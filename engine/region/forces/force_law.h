#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/region/node_motion.h"

namespace hazumi {

// Where a node's origin is and how it moves, in the world [m, m/s].
struct NodePlace {
  small::V3 p, v;
};

// A region's model at one instant, as a force law sees it. World axes; points of the kinematics are
// from the root's origin.
struct RegionState {
  double t;  // [s]
  const RegionModel& model;
  const RegionLayout& layout;
  const DrivenMotion& driven;        // read for what drives are told
  const NodeKinematics& kinematics;  // where the nodes are, and how they turn
  const double* positions;           // of the free joints, as in the layout
  const double* velocities;
  const std::vector<NodePlace>& places;  // by node, for laws that act from outside

  // Of a point of a node, r from its origin.
  small::V3 PositionAt(int node, const small::V3& r) const { return places[node].p + r; }
  small::V3 VelocityAt(int node, const small::V3& r) const {
    return places[node].v + Cross(kinematics.motion()[node].w, r);
  }
};

// A drive that gives all that it can, with half or more of its strength, and would give more.
struct SpentDrive {
  bool is_ball = false;
  int hinge = 0;                      // free; of a ball joint the first one
  double torque = 0.0, wanted = 0.0;  // or moments [N m]
  double lag = 0.0, approach = 0.0;   // from what it pulls to; how fast that shrinks [rad, rad/s]
};

// Moment in a joint on its node against the parent, linearized for a turn of the node by phi and
// with w: moment - stiffness phi - damping (w - w_0). World axes.
struct JointSpring {
  int node = 0;
  Vec3 moment = Vec3::Zero();     // [N m]
  Mat3 stiffness = Mat3::Zero();  // symmetric, positive semidefinite [N m]
  Mat3 damping = Mat3::Zero();    // likewise [N m s]
};

// What acts on the links of a region's model, one after the other. A law acts in one of two ways:
// by forces, which the equations of motion take in, or as a rule for the accelerations that come
// out of them. Its power is found from what it does, by RegionDynamics::MeasureEnergy.
class ForceLaw {
 public:
  virtual ~ForceLaw() = default;

  // In the account of energy.
  virtual std::string_view name() const = 0;
  // Adds its forces on the nodes (NodeKinematics::AddForce, AddTorque, AddJointMoment).
  virtual void AddForces(const RegionState&, NodeKinematics*) const {}
  // Adds to the accelerations of the free joints, by dof of the layout [rad/s^2].
  virtual void AddAccelerations(const RegionState&, double* /*x*/) const {}
  // True if it adds any, ever.
  virtual bool is_rule() const { return false; }
  // True if its forces come from outside the figure: it may ask where nodes are in the world, and a
  // figure in flight falls otherwise than freely.
  virtual bool is_outer() const { return false; }
  // Adds its drives that are spent.
  virtual void ListSpent(const RegionState&, std::vector<SpentDrive>*) const {}
  // Appends what changes its sign where its forces have a kink: steps end there. As many numbers
  // each time.
  virtual void AppendKinks(const RegionState&, std::vector<double>* /*kinks*/) const {}
  virtual bool has_kinks() const { return false; }
  // Returns whether the whole law consists of springs in joints that may be implicit.
  virtual bool is_spring() const { return false; }
  virtual void ListSprings(const RegionState&, std::vector<JointSpring>*) const {}
  // Limits such a moment on a node to its largest magnitude, world axes [N m].
  virtual Vec3 Limit(const RegionState&, int /*node*/, const Vec3& moment) const { return moment; }
  // How fast it changes a motion, at most [1/s]: steps are not much longer than the inverse.
  virtual double FastestRate() const { return 0.0; }
};

using ForceLaws = std::vector<std::shared_ptr<const ForceLaw>>;

}  // namespace hazumi
