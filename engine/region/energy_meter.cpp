// Over the bodies of an island (mass m, h = m c, inertia I about the origin, which moves with v,
// w):
//   kinetic    sum m v.v / 2 + v.(w x h) + w.(I w) / 2,     potential    g sum (m z + h_z)
// Power comes in by laws that give forces F and torques M, sum F.v + M.w; and through a joint, n.(w
// - w_parent) with n what inverse dynamics asks of it at the accelerations found, less what laws
// give. The power of a rule is what its accelerations ask of the joints: with them, less without.

#include "engine/region/energy_meter.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

EnergyMeter::EnergyMeter(const Instant& at, RegionKinematics* kinematics)
    : at_(at),
      kinematics_(kinematics),
      state_(kinematics->PlaceWithChain(at.equations.state().t, at.equations.layout(),
                                        at.equations.state().positions,
                                        at.equations.state().velocities)),
      nodes_(&kinematics->nodes()) {
  Accelerate(at.x);
  v_.resize(nodes_->size());
  V3 v_root = kinematics_->RootVelocity(state_.t, &v_);
  if (sees_world()) v_root += V3(at_.outer.anchor.v);
  for (V3& velocity : v_) velocity = velocity + v_root;
  for (const BodyMotion& ball : at_.outer.balls) v_.emplace_back(ball.v);
}

// Adds accelerations x of the directions to the motion of all nodes, the chain's included, and sets
// what each then asks of its joint.
void EnergyMeter::Accelerate(const VecX& x) {
  kinematics_->Accelerate(state_.layout, x.data());
  // A pin stays where it is with the accelerations that are now in.
  const V3 base = kinematics_->BaseAcceleration(state_.t);
  Load(base);
  if (at_.model.coupling != RootCoupling::kFlight) return;
  V3 force;
  for (int i = 0; i < nodes_->size(); ++i) force += nodes_->motion()[i].f;
  Load(base - (1.0 / at_.model.mass) * force);
}

void EnergyMeter::Load(const V3& base) {
  kinematics_->AskForInertia(state_.t, base, at_.outer);
  if (at_.has_rows) at_.rows.AddForces(RowSystem::Kind::kAll, nodes_);
  at_.laws.Load(state_, at_.mode.constant, at_.bodies, nodes_);
}

void EnergyMeter::MeasureEnergy(EnergyFlow* flow) const {
  const RegionModel& model = at_.model;
  const auto& motion = nodes_->motion();
  const bool is_pinned = model.coupling == RootCoupling::kPinned;
  const NodeMotion& pin = motion[is_pinned ? model.pin_node : 0];
  const V3 p_pin = pin.p + pin.R * V3(model.p_pin);
  const double gravity = at_.bodies.gravity();
  const double root_z =
      is_pinned ? -p_pin.z : kinematics_->driven().root_position[2].At(state_.t).v;
  for (int i = 0; i < nodes_->size(); ++i) {
    if (!model.nodes[i].is_dynamic) continue;
    const NodeMotion& own = motion[i];
    flow->kinetic += 0.5 * own.m * Dot(v_[i], v_[i]) + Dot(v_[i], Cross(own.w, own.h)) +
                     0.5 * Dot(own.w, own.I * own.w);
    flow->potential += gravity * (own.m * (own.p.z + root_z) + own.h.z);
  }
  if (model.coupling == RootCoupling::kFlight) {
    flow->potential = sees_world() ? gravity * model.mass * at_.outer.anchor.p.z() : 0.0;
  }
  flow->kinetic += at_.bodies.KineticEnergy(at_.outer);
  at_.bodies.AddPotentialEnergy(at_.outer, &flow->potential);
}

void EnergyMeter::SumForces() {
  auto& motion = nodes_->motion();
  for (int i = nodes_->size() - 1; i >= 0; --i) {
    const int parent = at_.model.nodes[i].parent;
    if (parent < 0 || !at_.model.nodes[parent].is_dynamic || !at_.model.nodes[i].is_dynamic) {
      continue;
    }
    motion[parent].f += motion[i].f;
    motion[parent].n += motion[i].n + Cross(motion[i].r, motion[i].f);
  }
}

// Returns the power through the free joints. Adds the power that comes in elsewhere to `keyed`.
double EnergyMeter::PowerInJoints(double* keyed) {
  SumForces();
  const RegionModel& model = at_.model;
  const auto& motion = nodes_->motion();
  const bool is_pinned = model.coupling == RootCoupling::kPinned;
  // The force that carries the figure acts at the pin, not at the root.
  const bool at_pin = is_pinned && model.root_answers;
  const NodeMotion& pin = motion[is_pinned ? model.pin_node : 0];
  const V3 p_pin = pin.p + pin.R * V3(model.p_pin);
  const V3 f_pin = at_pin ? motion[0].f : V3();
  double free = 0.0;
  for (int i = 0; i < nodes_->size(); ++i) {
    if (!model.nodes[i].is_dynamic) {  // the keys respond to forces of laws
      if (at_.laws.any_forces() || at_.has_rows)
        *keyed += Dot(motion[i].f, v_[i]) + Dot(motion[i].n, motion[i].w);
      continue;
    }
    const int parent = model.nodes[i].parent;
    const V3 w_parent = parent < 0 ? V3() : motion[parent].w;
    V3 moment = motion[i].n;
    bool to_pin = false;
    for (int k = model.pin_node; at_pin && k >= 0; k = model.nodes[k].parent) to_pin |= k == i;
    if (to_pin) moment -= Cross(p_pin - motion[i].p, f_pin);
    const double power = Dot(moment, motion[i].w - w_parent);
    (model.nodes[i].role == Role::kFree ? free : *keyed) += power;
    if (parent >= 0 && model.nodes[parent].is_dynamic) continue;
    if (model.root_answers) continue;
    *keyed += Dot(motion[i].f, v_[i]) + Dot(motion[i].n, w_parent);
  }
  return free;
}

// Returns the power in the joints without the accelerations of a rule.
double EnergyMeter::PowerWithout(const ForceLaw& rule) {
  VecX added(state_.layout.num_hinges());
  at_.equations.FindRule(rule, &added);
  added.conservativeResize(state_.layout.num_dofs());
  Accelerate(-added);
  double keyed = 0.0;
  const double power = PowerInJoints(&keyed);
  kinematics_->Accelerate(state_.layout, added.data());
  return power;
}

// Returns the power in the joints without the accelerations of rules. A joint that moves no mass
// does not respond to forces, so their work on it is not part of the energy balance.
double EnergyMeter::PowerWithoutRules() {
  for (const auto& law : at_.laws.all()) {
    if (law->is_rule()) return PowerWithout(*law);
  }
  return 0.0;
}

double EnergyMeter::PowerOf(const ForceLaw& law) {
  nodes_->ClearForces();
  RegionLaws::AddForces(law, state_, at_.mode.constant, nodes_);
  return PowerOnNodes();
}

double EnergyMeter::PowerOfRows(RowSystem::Kind kind) {
  nodes_->ClearForces();
  at_.rows.AddForces(kind, nodes_);
  return PowerOnNodes();
}

double EnergyMeter::PowerOnNodes() const {
  double power = 0.0;
  for (size_t i = 0; i < v_.size(); ++i) {
    const NodeMotion& own = nodes_->motion()[i];
    power -= Dot(own.f, v_[i]) + Dot(own.n, own.w);
  }
  return power;
}

EnergyFlow EnergyMeter::Measure() {
  EnergyFlow flow;
  MeasureEnergy(&flow);
  const double in_joints = PowerInJoints(&flow.keyed);
  for (const auto& law : at_.laws.all()) {
    const double power = law->is_rule() ? in_joints - PowerWithout(*law) : PowerOf(*law);
    flow.laws.push_back({std::string(law->name()), power});
  }
  if (at_.has_weightless) {
    const double lost = at_.laws.any_rules() ? PowerWithoutRules() : in_joints;
    flow.laws.push_back({"weightless joints", lost});
  }
  if (!at_.mode.constraints.specs().empty()) {
    flow.laws.push_back({"constraints", PowerOfRows(RowSystem::Kind::kConstraints)});
  }
  if (at_.mode.contacts.is_possible()) {
    const double power = PowerOfRows(RowSystem::Kind::kContacts);
    nodes_->ClearForces();
    at_.mode.constant.AddTo(nodes_);
    flow.laws.push_back({"contact", power + PowerOnNodes()});
  }
  return flow;
}

}  // namespace hazumi
