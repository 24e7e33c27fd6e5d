#include "engine/passive/region_dynamics.h"

#include <algorithm>
#include <cmath>

#include "engine/passive/semidefinite.h"

// The dense way: with the composite body beyond node i (m, h = m c, I about its origin) every free
// direction e of it needs, per unit acceleration,
//   f = e x h,  n = I e;   M(e', e) = e' . n about the origin of e', for e' between i and the root
//   b(e) = e . n_i, n_i what everything beyond asks for with the free accelerations zero
// [Luh, Walker, Paul 1980] for b, composite rigid bodies [Featherstone 2008, 6.2] for M.

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

RegionDynamics::RegionDynamics(RegionModel model, ForceLaws laws, double gravity)
    : model_(std::move(model)),
      layout_(model_, /*balls=*/true),
      hinge_layout_(model_, /*balls=*/false),
      kinematics_(model_),
      articulated_(model_),
      laws_(std::move(laws)),
      gravity_(gravity) {
  while (!model_.nodes[first_moved_].is_dynamic) ++first_moved_;
  for (const auto& law : laws_) {
    (law->is_rule() ? has_rules_ : has_forces_) = true;
    has_outer_ |= law->is_outer();
  }
  if (has_outer_) {
    places_.resize(model_.nodes.size());
    velocities_.resize(model_.nodes.size());
  }
  added_.setZero(num_hinges());
}

double RegionDynamics::FastestRate() const {
  double rate = 0.0;
  for (const auto& law : laws_) rate = std::max(rate, law->FastestRate());
  return rate;
}

// At the first dense evaluation: a long chain may never need one.
void RegionDynamics::MakeRoomForDense() {
  const int k = num_hinges();
  if (M_.cols() == k && F_.cols() == k) return;
  b_.setZero(k);
  M_.setZero(k, k);
  F_.setZero(3, k);
  J_.setZero(3, k);
}

void RegionDynamics::SetCurves(const DrivenMotion* driven, double start) {
  driven_ = driven;
  if (first_moved_ == 0) return;
  is_carrier_still_ = IsCarrierStill();
  if (is_carrier_still_) PlaceStillCarrier(start);
}

// Where it is, it stays: the nodes that move it are placed once.
void RegionDynamics::PlaceStillCarrier(double t) {
  kinematics_.Move(layout_, *driven_, t, nullptr, nullptr, 0, first_moved_);
  NodeMotion& carrier = kinematics_.motion()[model_.nodes[first_moved_].parent];
  carrier.a += BaseAcceleration(t);
}

bool RegionDynamics::IsCarrierStill() const {
  for (int i = 0; i < first_moved_; ++i) {
    if (model_.nodes[i].role == Role::kDriven) return false;
  }
  const auto& root = driven_->root_position;
  const auto accelerates = [](const DrivenCurve& curve) { return curve.degree > 1; };
  return model_.coupling == RootCoupling::kPinned ||
         std::none_of(root.begin(), root.end(), accelerates);
}

// A pinned root that answers couples every joint with the pin, which is solved the dense way unless
// that takes too long. Only the dense way is written for rules that the root has to answer.
bool RegionDynamics::UsesArticulatedBodies() const {
  if (!model_.root_answers) return true;
  if (has_rules_ && model_.nodes[0].role == Role::kFree) return false;
  return model_.coupling == RootCoupling::kFlight || model_.num_free > most_dense_;
}

void RegionDynamics::Move(double t, const RegionLayout& layout, const double* positions,
                          const double* velocities) {
  const int count = kinematics_.size();
  if (first_moved_ > 0 && !is_carrier_still_) MoveCarrier(t);
  kinematics_.Move(layout, *driven_, t, positions, velocities, first_moved_, count);
  AskForForces(first_moved_ > 0 ? V3() : BaseAcceleration(t),
               StateAt(t, layout, positions, velocities));
}

// What the nodes ask for, accelerated by `base` on top, what the laws give them taken off.
void RegionDynamics::AskForForces(const V3& base, const RegionState& state) {
  if (has_forces_) kinematics_.ClearForces();  // of nodes that weigh nothing here too
  kinematics_.SetOwnForces(base);
  if (has_outer_) PlaceNodes(state.t);
  if (!has_forces_) return;
  for (const auto& law : laws_) law->AddForces(state, &kinematics_);
}

RegionState RegionDynamics::StateAt(double t, const RegionLayout& layout, const double* positions,
                                    const double* velocities) const {
  return {t, model_, layout, kinematics_, positions, velocities, places_};
}

std::shared_ptr<const MovingBase> RegionDynamics::FitMovingBase(double start, double end) {
  return std::make_shared<const MovingBase>(start, end, [&](double t) { return CarrierAt(t); });
}

MovingBase::Frame RegionDynamics::CarrierAt(double t) {
  const NodeMotion& own = kinematics_.motion()[model_.nodes[first_moved_].parent];
  kinematics_.Move(layout_, *driven_, t, nullptr, nullptr, 0, first_moved_);
  return {own.R, own.w, own.alpha, own.a + BaseAcceleration(t)};
}

void RegionDynamics::MoveCarrier(double t) {
  // Laws that act from outside ask for more of the chain than a moving base knows.
  const bool is_fitted = !has_outer_ && moving_base_->Covers(t);
  const MovingBase::Frame frame = is_fitted ? moving_base_->At(t) : CarrierAt(t);
  NodeMotion& own = kinematics_.motion()[model_.nodes[first_moved_].parent];
  own.R = frame.R;
  own.w = frame.w;
  own.alpha = frame.alpha;
  own.a = frame.a;
}

// What every point of the figure has on top of its motion about the root: the root's acceleration
// minus gravity. In flight the figure falls freely, so it feels neither.
V3 RegionDynamics::BaseAcceleration(double t) const {
  const V3 up(0.0, 0.0, gravity_);
  if (model_.coupling == RootCoupling::kFlight) return {};
  if (model_.coupling == RootCoupling::kPinned) {
    const NodeMotion& pin = kinematics_.motion()[model_.pin_node];
    const V3 r = pin.R * V3(model_.p_pin);
    return up - (pin.a + Cross(pin.alpha, r) + Cross(pin.w, Cross(pin.w, r)));
  }
  const auto& root = driven_->root_position;
  return up + V3(root[0].At(t).dd, root[1].At(t).dd, root[2].At(t).dd);
}

void RegionDynamics::Assemble(const RegionLayout& layout) {
  MakeRoomForDense();
  for (int i = 0; i < layout.num_dofs(); ++i) std::fill_n(&M_(0, i), layout.num_dofs(), 0.0);
  for (int i = kinematics_.size() - 1; i >= 0; --i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const RegionLayout::Node& where = layout.node(i);
    const NodeMotion& own = kinematics_.motion()[i];
    for (int k = 0; k < where.num_dofs; ++k) {
      AssembleColumn(layout, i, where.dof + k, own.axis[k]);
      b_[where.dof + k] = Dot(own.axis[k], own.n);
    }
    PassToParent(i);
  }
  if (model_.root_answers) Couple(layout);
}

void RegionDynamics::AssembleColumn(const RegionLayout& layout, int node, int dof, const V3& axis) {
  const auto& motion = kinematics_.motion();
  const V3 f = Cross(axis, motion[node].h);
  V3 n = motion[node].I * axis;
  F_.col(dof) << f.x, f.y, f.z;
  for (int i = node;; i = model_.nodes[i].parent) {
    const RegionLayout::Node& where = layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) {
      M_(where.dof + k, dof) = M_(dof, where.dof + k) = Dot(motion[i].axis[k], n);
    }
    const int parent = model_.nodes[i].parent;
    if (parent < 0 || !model_.nodes[parent].is_dynamic) return;
    n += Cross(motion[i].r, f);
  }
}

void RegionDynamics::PassToParent(int node) {
  const int parent = model_.nodes[node].parent;
  if (parent < 0 || !model_.nodes[parent].is_dynamic) return;
  const NodeMotion& own = kinematics_.motion()[node];
  NodeMotion& to = kinematics_.motion()[parent];
  const V3 &r = own.r, &h = own.h;
  const V3 g = h + own.m * r;  // of the composite about the parent's origin
  const double d = Dot(r, h) + Dot(r, g);
  to.f += own.f;
  to.n += own.n + Cross(r, own.f);
  to.m += own.m;
  to.h += g;
  to.I += own.I;
  to.I += S3{d - r.x * h.x - g.x * r.x, -r.x * h.y - g.x * r.y, -r.x * h.z - g.x * r.z,
             d - r.y * h.y - g.y * r.y, -r.y * h.z - g.y * r.z, d - r.z * h.z - g.z * r.z};
}

// Eliminates the root's translation, as RegionSystem does.
void RegionDynamics::Couple(const RegionLayout& layout) {
  if (model_.coupling == RootCoupling::kPinned) return ProjectOnPin(layout);
  const Vec3 f_root = kinematics_.motion()[0].f.eigen();
  for (int j = 0; j < layout.num_dofs(); ++j) {
    const Vec3 column = F_.col(j) / model_.mass;
    for (int i = 0; i < layout.num_dofs(); ++i) M_(i, j) -= F_.col(i).dot(column);
    b_[j] -= column.dot(f_root);
  }
}

void RegionDynamics::SolveDense(double* x) {
  const int k = layout_.num_dofs();
  Assemble(layout_);
  if (L_.cols() != num_hinges()) L_.setZero(num_hinges(), num_hinges());
  for (int j = 0; j < k; ++j) std::copy_n(&M_(0, j), k, &L_(0, j));
  FactorSemidefinite(L_.topLeftCorner(k, k));
  Eigen::Map<VecX> solution(x, k);
  solution = -b_.head(k);
  SolveSemidefinite(L_.topLeftCorner(k, k), solution);
}

// c'' = g + sum F / m
void RegionDynamics::Fall(double* dy) const {
  const Vec3 push = kinematics_.added_force().eigen() / model_.mass;
  Eigen::Map<Vec3>(dy + layout_.state_size()) = anchor_.v;
  Eigen::Map<Vec3>(dy + layout_.state_size() + 3) = push - gravity_ * Vec3::UnitZ();
}

void RegionDynamics::SetAnchorOf(const double* y) {
  if (!is_pushed_in_flight()) return;
  anchor_.p = Eigen::Map<const Vec3>(y + layout_.state_size());
  anchor_.v = Eigen::Map<const Vec3>(y + layout_.state_size() + 3);
}

void RegionDynamics::PackAnchor(double* y) const {
  if (!is_pushed_in_flight()) return;
  Eigen::Map<Vec3>(y + layout_.state_size()) = anchor_.p;
  Eigen::Map<Vec3>(y + layout_.state_size() + 3) = anchor_.v;
}

void RegionDynamics::Derivative(double t, const double* y, double* dy) {
  ++evaluations_;
  SetAnchorOf(y);
  const double* velocities = y + layout_.num_positions();
  double* x = dy + layout_.num_positions();
  Move(t, layout_, y, velocities);
  if (UsesArticulatedBodies()) {
    SolveLarge(layout_, x);
  } else {
    SolveDense(x);
  }
  if (has_rules_) AddRules(t, y, x);
  if (is_pushed_in_flight()) Fall(dy);
  for (const RegionLayout::Node& own : layout_.nodes()) {
    if (own.kind == RegionLayout::NodeKind::kHinges) {
      std::copy_n(velocities + own.dof, own.num_dofs, dy + own.position);
    }
    if (own.kind != RegionLayout::NodeKind::kBall) continue;
    // q' = q (0, w) / 2
    const double* q = y + own.position;
    const double* w = velocities + own.dof;
    double* qd = dy + own.position;
    qd[0] = 0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]);
    qd[1] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
    qd[2] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
    qd[3] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
  }
}

void RegionDynamics::AddRules(double t, const double* y, double* x) {
  const RegionState state = StateAt(t, layout_, y, y + layout_.num_positions());
  for (const auto& law : laws_) {
    if (!law->is_rule()) continue;
    AddRule(*law, state);
    for (int i = 0; i < layout_.num_dofs(); ++i) x[i] += added_[i];
  }
}

// Sets added_ to what a rule adds.
void RegionDynamics::AddRule(const ForceLaw& rule, const RegionState& state) {
  added_.setConstant(-0.0);  // which leaves the sign of any zero that is added
  rule.AddAccelerations(state, added_.data());
  if (model_.root_answers && model_.nodes[0].role == Role::kFree) AnswerRule();
}

// What a rule does inside the figure leaves its angular momentum alone: the root is solved again.
void RegionDynamics::AnswerRule() {
  if (layout_.node(0).num_dofs == 0) return;
  Vec3 answer = Vec3::Zero();
  for (int j = 3; j < layout_.num_dofs(); ++j) answer -= M_.block<3, 1>(0, j) * added_[j];
  const Mat3 M_rr = M_.topLeftCorner<3, 3>();
  added_.head<3>() = M_rr.ldlt().solve(answer);
}

void RegionDynamics::AssembleHinges(double t, const VecX& q, const VecX& qd) {
  ++evaluations_;
  ++assembled_;
  Move(t, hinge_layout_, q.data(), qd.data());
  Assemble(hinge_layout_);
}

}  // namespace hazumi
