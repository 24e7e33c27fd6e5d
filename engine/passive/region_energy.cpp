// Energy and power of a region model: an inverse dynamics pass with the accelerations found.

#include "engine/passive/region_dynamics.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

// Places and moves all nodes, chains included, with accelerations x of the free joints, and sets
// what each asks of its joint.
void RegionDynamics::MoveWith(double t, const double* y, const double* x) {
  kinematics_.Move(layout_, *driven_, t, y, y + layout_.num_positions(), 0, kinematics_.size());
  kinematics_.Accelerate(layout_, x, first_moved_);
  // A pin stays where it is under the accelerations that are now in.
  V3 base = BaseAcceleration(t);
  kinematics_.SetOwnForces(base);
  if (model_.coupling != RootCoupling::kFlight) return;
  V3 force;
  for (int i = 0; i < kinematics_.size(); ++i) force += kinematics_.motion()[i].f;
  base -= (1.0 / model_.mass) * force;
  kinematics_.SetOwnForces(base);
}

// Velocities of the nodes' origins relative to the root's, and that of the root.
V3 RegionDynamics::RootVelocity(double t, std::vector<V3>* velocity) const {
  const auto& motion = kinematics_.motion();
  V3 momentum;
  for (int i = 0; i < kinematics_.size(); ++i) {
    const int parent = model_.nodes[i].parent;
    V3& v = (*velocity)[i];
    v = parent < 0 ? V3() : (*velocity)[parent] + Cross(motion[parent].w, motion[i].r);
    if (!model_.nodes[i].is_dynamic) continue;
    momentum += motion[i].m * v + Cross(motion[i].w, motion[i].h);
  }
  if (model_.coupling == RootCoupling::kFlight) return (-1.0 / model_.mass) * momentum;
  if (model_.coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = motion[model_.pin_node];
    return -((*velocity)[model_.pin_node] + Cross(pin.w, pin.R * V3(model_.p_pin)));
  }
  const auto& root = driven_->root_position;
  return {root[0].At(t).d, root[1].At(t).d, root[2].At(t).d};
}

void RegionDynamics::SumForces() {
  auto& motion = kinematics_.motion();
  for (int i = kinematics_.size() - 1; i >= 0; --i) {
    const int parent = model_.nodes[i].parent;
    if (parent < 0 || !model_.nodes[parent].is_dynamic || !model_.nodes[i].is_dynamic) continue;
    motion[parent].f += motion[i].f;
    motion[parent].n += motion[i].n + Cross(motion[i].r, motion[i].f);
  }
}

EnergyFlow RegionDynamics::MeasureEnergy(double t, const double* y) {
  std::vector<double> dy(layout_.state_size());
  Derivative(t, y, dy.data());
  MoveWith(t, y, dy.data() + layout_.num_positions());
  const auto& motion = kinematics_.motion();
  std::vector<V3> velocity(motion.size());
  const V3 v_root = RootVelocity(t, &velocity);
  const bool is_pinned = model_.coupling == RootCoupling::kPinned;
  const NodeMotion& pin = motion[is_pinned ? model_.pin_node : 0];
  const V3 p_pin = pin.p + pin.R * V3(model_.p_pin);
  const double root_z = is_pinned ? -p_pin.z : driven_->root_position[2].At(t).v;
  EnergyFlow flow;
  for (int i = 0; i < kinematics_.size(); ++i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const NodeMotion& own = motion[i];
    const V3 v = velocity[i] + v_root;
    flow.kinetic +=
        0.5 * own.m * Dot(v, v) + Dot(v, Cross(own.w, own.h)) + 0.5 * Dot(own.w, own.I * own.w);
    flow.potential += gravity_ * (own.m * (own.p.z + root_z) + own.h.z);
  }
  if (model_.coupling == RootCoupling::kFlight) flow.potential = 0.0;
  SumForces();
  // What holds the figure acts at the pin, not at the root.
  const bool at_pin = is_pinned && model_.root_answers;
  const V3 f_pin = at_pin ? motion[0].f : V3();
  for (int i = 0; i < kinematics_.size(); ++i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const int parent = model_.nodes[i].parent;
    const V3 w_parent = parent < 0 ? V3() : motion[parent].w;
    V3 moment = motion[i].n;
    bool to_pin = false;
    for (int k = model_.pin_node; at_pin && k >= 0; k = model_.nodes[k].parent) to_pin |= k == i;
    if (to_pin) moment -= Cross(p_pin - motion[i].p, f_pin);
    const double power = Dot(moment, motion[i].w - w_parent);
    (model_.nodes[i].role == Role::kFree ? flow.friction : flow.keyed) += power;
    if (parent >= 0 && model_.nodes[parent].is_dynamic) continue;
    if (model_.root_answers) continue;
    flow.keyed += Dot(motion[i].f, velocity[i] + v_root) + Dot(motion[i].n, w_parent);
  }
  if (first_moved_ > 0 && is_carrier_still_) PlaceStillCarrier(t);
  return flow;
}

}  // namespace hazumi
