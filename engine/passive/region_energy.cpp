// Energy and power of a region model [METHOD 8.5], over its bodies (mass m, h = m c, inertia I
// about the origin, which moves with v, w):
//   kinetic    sum m v.v / 2 + v.(w x h) + w.(I w) / 2,     potential    g sum (m z + h_z)
// What comes in: by laws that give forces F and torques M, sum F.v + M.w; through a joint, n.(w -
// w_parent) with n what inverse dynamics asks of it at the accelerations found, less what laws
// give.

#include "engine/passive/region_dynamics.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

// Adds accelerations x of the free joints to what all nodes, chains included, move with, and sets
// what each then asks of its joint.
void RegionDynamics::Accelerate(const RegionState& state, const VecX& x) {
  kinematics_.Accelerate(layout_, x.data(), first_moved_);
  // A pin stays where it is under the accelerations that are now in.
  const V3 base = BaseAcceleration(state.t);
  AskForForces(base, state);
  if (model_.coupling != RootCoupling::kFlight) return;
  V3 force;
  for (int i = 0; i < kinematics_.size(); ++i) force += kinematics_.motion()[i].f;
  AskForForces(base - (1.0 / model_.mass) * force, state);
}

// The velocity of the root; `velocity` gets those of the nodes' origins relative to it.
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

// In the world.
V3 RegionDynamics::RootPosition(double t) const {
  const auto& motion = kinematics_.motion();
  const V3 anchor(outer_.anchor.p);
  if (model_.coupling == RootCoupling::kFlight) {
    V3 sum;
    for (const NodeMotion& own : motion) sum += own.m * own.p + own.h;
    return anchor - (1.0 / model_.mass) * sum;
  }
  if (model_.coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = motion[model_.pin_node];
    return anchor - (pin.p + pin.R * V3(model_.p_pin));
  }
  const auto& root = driven_->root_position;
  return {root[0].At(t).v, root[1].At(t).v, root[2].At(t).v};
}

void RegionDynamics::PlaceNodes(double t) {
  const V3 p_root = RootPosition(t);
  V3 v_root = RootVelocity(t, &velocities_);
  if (model_.coupling == RootCoupling::kFlight) v_root += V3(outer_.anchor.v);
  for (int i = 0; i < kinematics_.size(); ++i) {
    places_[i] = {p_root + kinematics_.motion()[i].p, v_root + velocities_[i]};
  }
  PlaceBalls(p_root);
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

// Of what a law's forces do to the nodes, which move with velocities v.
double RegionDynamics::PowerOf(const ForceLaw& law, const RegionState& state,
                               const std::vector<V3>& v) {
  kinematics_.ClearForces();
  if (frozen_.holds_springs && law.is_spring()) {
    frozen_.AddSpringsTo(&kinematics_);
  } else {
    law.AddForces(state, &kinematics_);
  }
  return PowerOnNodes(v);
}

double RegionDynamics::PowerOnNodes(const std::vector<V3>& v) const {
  double power = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    const NodeMotion& own = kinematics_.motion()[i];
    power -= Dot(own.f, v[i]) + Dot(own.n, own.w);
  }
  return power;
}

// What comes in through the free joints; with what comes in elsewhere added to `keyed`. Velocities
// v of the nodes' origins.
double RegionDynamics::PowerInJoints(const std::vector<V3>& v, double* keyed) {
  SumForces();
  const auto& motion = kinematics_.motion();
  const bool is_pinned = model_.coupling == RootCoupling::kPinned;
  // What holds the figure acts at the pin, not at the root.
  const bool at_pin = is_pinned && model_.root_answers;
  const NodeMotion& pin = motion[is_pinned ? model_.pin_node : 0];
  const V3 p_pin = pin.p + pin.R * V3(model_.p_pin);
  const V3 f_pin = at_pin ? motion[0].f : V3();
  double free = 0.0;
  for (int i = 0; i < kinematics_.size(); ++i) {
    if (!model_.nodes[i].is_dynamic) {  // the keys answer what laws do to it
      if (has_forces_ || has_rows_)
        *keyed += Dot(motion[i].f, v[i]) + Dot(motion[i].n, motion[i].w);
      continue;
    }
    const int parent = model_.nodes[i].parent;
    const V3 w_parent = parent < 0 ? V3() : motion[parent].w;
    V3 moment = motion[i].n;
    bool to_pin = false;
    for (int k = model_.pin_node; at_pin && k >= 0; k = model_.nodes[k].parent) to_pin |= k == i;
    if (to_pin) moment -= Cross(p_pin - motion[i].p, f_pin);
    const double power = Dot(moment, motion[i].w - w_parent);
    (model_.nodes[i].role == Role::kFree ? free : *keyed) += power;
    if (parent >= 0 && model_.nodes[parent].is_dynamic) continue;
    if (model_.root_answers) continue;
    *keyed += Dot(motion[i].f, v[i]) + Dot(motion[i].n, w_parent);
  }
  return free;
}

// A rule's power is what its accelerations ask of the free joints: with them, less without.
double RegionDynamics::PowerWithout(const ForceLaw& rule, const RegionState& state,
                                    const std::vector<V3>& v) {
  AddRule(rule, state);
  const VecX added = added_.head(layout_.num_dofs());
  Accelerate(state, -added);
  double keyed = 0.0;
  const double power = PowerInJoints(v, &keyed);
  kinematics_.Accelerate(layout_, added.data(), first_moved_);
  return power;
}

// Power in the joints without the accelerations of rules. A joint that moves no mass does not
// respond to forces, so their work on it is not part of the energy balance.
double RegionDynamics::PowerWithoutRules(const RegionState& state, const std::vector<V3>& v) {
  for (const auto& law : laws_) {
    if (law->is_rule()) return PowerWithout(*law, state, v);
  }
  return 0.0;
}

void RegionDynamics::AddStoredEnergy(double t, const std::vector<V3>& v, EnergyFlow* flow) const {
  const auto& motion = kinematics_.motion();
  const bool is_pinned = model_.coupling == RootCoupling::kPinned;
  const NodeMotion& pin = motion[is_pinned ? model_.pin_node : 0];
  const V3 p_pin = pin.p + pin.R * V3(model_.p_pin);
  const double root_z = is_pinned ? -p_pin.z : driven_->root_position[2].At(t).v;
  for (int i = 0; i < kinematics_.size(); ++i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const NodeMotion& own = motion[i];
    flow->kinetic += 0.5 * own.m * Dot(v[i], v[i]) + Dot(v[i], Cross(own.w, own.h)) +
                     0.5 * Dot(own.w, own.I * own.w);
    flow->potential += gravity_ * (own.m * (own.p.z + root_z) + own.h.z);
  }
  if (model_.coupling == RootCoupling::kFlight) {
    flow->potential = sees_world() ? gravity_ * model_.mass * outer_.anchor.p.z() : 0.0;
  }
}

EnergyFlow RegionDynamics::MeasureEnergy(double t, const double* y) {
  VecX dy(state_size());
  Derivative(t, y, dy.data());
  const RegionState state = StateAt(t, layout_, y, y + layout_.num_positions());
  kinematics_.Move(layout_, *driven_, t, state.positions, state.velocities, 0, kinematics_.size());
  adds_rows_ = has_rows_;
  Accelerate(state, dy.segment(layout_.num_positions(), layout_.num_dofs()));
  std::vector<V3> v(kinematics_.size());
  V3 v_root = RootVelocity(t, &v);
  if (sees_world()) v_root += V3(outer_.anchor.v);
  for (V3& velocity : v) velocity = velocity + v_root;
  for (const BodyMotion& ball : outer_.balls) v.emplace_back(ball.v);
  EnergyFlow flow;
  AddStoredEnergy(t, v, &flow);
  AddEnergyOfBalls(&flow);
  const double in_joints = PowerInJoints(v, &flow.keyed);
  for (const auto& law : laws_) {
    const double power =
        law->is_rule() ? in_joints - PowerWithout(*law, state, v) : PowerOf(*law, state, v);
    flow.laws.push_back({std::string(law->name()), power});
  }
  if (has_weightless_) {
    const double lost = has_rules_ ? PowerWithoutRules(state, v) : in_joints;
    flow.laws.push_back({"weightless joints", lost});
  }
  if (!rows_.specs().empty()) {
    flow.laws.push_back({"constraints", PowerOfRows(RowsOf::kConstraints, v)});
  }
  if (contacts_.is_possible()) {
    const double power = PowerOfRows(RowsOf::kContacts, v);
    kinematics_.ClearForces();
    frozen_.AddTo(&kinematics_);
    flow.laws.push_back({"contact", power + PowerOnNodes(v)});
  }
  adds_rows_ = false;
  if (first_moved_ > 0 && is_carrier_still_) PlaceStillCarrier(t);
  return flow;
}

}  // namespace hazumi
