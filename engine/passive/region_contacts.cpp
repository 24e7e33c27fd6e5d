// What contacts of an island push with, and forces that stay for a while [METHOD 12].

#include <algorithm>
#include <utility>

#include "engine/passive/forces/hinge_moment.h"
#include "engine/passive/region_dynamics.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

void RegionDynamics::AssembleByTree(double t, const VecX& q, const VecX& qd, VecX* x_0,
                                    VecX* of_rows) {
  ++evaluations_;
  Move(t, hinge_layout_, q.data(), qd.data());
  by_bodies_ = true;
  x_0->resize(num_hinges());
  tree_.Solve(hinge_layout_, kinematics_.motion(), x_0->data());
  const RegionState state = StateAt(t, hinge_layout_, q.data(), qd.data());
  MeasureRows(state);
  VecX x = *x_0;
  AddRules(state, x.data());
  *of_rows = RowErrors(t, hinge_layout_, x.data());
}

// Kinetic energy of the rates alone. The motion (w, v) of each node contributes (m v v / 2 + v . (w
// x h) + w . I w / 2), and the energy of the centre of mass is subtracted.
double RegionDynamics::KineticEnergyOf(const VecX& qd) const {
  const auto& motion = kinematics_.motion();
  std::vector<V3> w(motion.size()), v(motion.size());
  V3 momentum;
  double energy = 0.0;
  for (int i = 0; i < kinematics_.size(); ++i) {
    if (!model_.nodes[i].is_dynamic) continue;
    const NodeMotion& own = motion[i];
    const int parent = model_.nodes[i].parent;
    if (parent >= 0) {
      w[i] = w[parent];
      v[i] = v[parent] + Cross(w[parent], own.r);
    }
    const RegionLayout::Node& where = hinge_layout_.node(i);
    for (int k = 0; k < where.num_dofs; ++k) w[i] += qd[where.dof + k] * own.axis[k];
    const V3 p = own.m * v[i] + Cross(w[i], own.h);
    momentum += p;
    energy += 0.5 * (Dot(v[i], p) + Dot(w[i], own.I * w[i] + Cross(own.h, v[i])));
  }
  const bool flies = model_.root_answers && model_.coupling == RootCoupling::kFlight;
  return flies ? energy - 0.5 * Dot(momentum, momentum) / model_.mass : energy;
}

void RegionDynamics::Freeze(const VecX& torques) {
  const auto& motion = kinematics_.motion();
  for (int i = 0; i < kinematics_.size(); ++i) {
    const RegionLayout::Node& node = hinge_layout_.node(i);
    if (node.num_dofs == 0) continue;
    const auto own = torques.segment(node.first_hinge, node.num_dofs);
    if (own.isZero(0.0)) continue;
    const V3 moment = FullMomentOfHinges(motion[i], node.num_dofs, own.data());
    frozen_.moments.push_back({i, TransposeTimes(motion[i].R, moment).eigen()});
  }
}

std::vector<JointSpring> RegionDynamics::Springs(const RegionState& state) const {
  std::vector<JointSpring> springs;
  for (const auto& law : laws_) law->ListSprings(state, &springs);
  return springs;
}

Eigen::Matrix3Xd RegionDynamics::AxesOf(const JointSpring& spring) const {
  const auto& axes = kinematics_.motion()[spring.node].axis;
  Eigen::Matrix3Xd all(3, hinge_layout_.node(spring.node).num_dofs);
  for (Eigen::Index i = 0; i < all.cols(); ++i) all.col(i) = axes[static_cast<size_t>(i)].eigen();
  return all;
}

Vec3 RegionDynamics::TurningOf(const JointSpring& spring) const {
  const auto& motion = kinematics_.motion();
  const int parent = model_.nodes[spring.node].parent;
  return (motion[spring.node].w - (parent < 0 ? V3() : motion[parent].w)).eigen();
}

void RegionDynamics::FreezeSprings(const std::vector<JointSpring>& springs,
                                   const RegionState& state) {
  frozen_.holds_springs = true;
  for (const JointSpring& own : springs) {
    Vec3 moment = own.moment;
    for (const auto& law : laws_) {
      if (law->is_spring()) moment = law->Limit(state, own.node, moment);
    }
    const Mat3 R_WN = kinematics_.motion()[own.node].R.eigen();
    frozen_.springs.push_back({own.node, R_WN.transpose() * moment});
  }
}

double RegionDynamics::ContactExcess() const {
  double pushes = 0.0, excess = 0.0;
  const std::vector<ConstraintRow>& rows = rows_.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].is_contact()) continue;
    const double push = row_forces_[static_cast<Eigen::Index>(k)];
    pushes += std::abs(push);
    excess = std::max(excess, -push);
    if (contacts_.pairs()[rows[k].contact].mode != ContactMode::kStick) continue;
    const double drag = row_forces_.segment<2>(static_cast<Eigen::Index>(k) + 1).norm();
    excess = std::max(excess, drag - contacts_.FrictionOf(rows[k].contact) * push);
    k += 2;
  }
  return pushes > 0.0 ? excess / pushes : 0.0;
}

// Of two, on the one that is a ball.
FrozenForces::Push RegionDynamics::PushOf(const ConstraintRow& row, const V3& force) const {
  const auto on_node = [&](int node, const V3& r) -> Vec3 {
    if (node < 0) return Vec3::Zero();
    return (model_.is_ball(node) ? r : TransposeTimes(kinematics_.motion()[node].R, r)).eigen();
  };
  FrozenForces::Push push;
  push.node = row.a;
  push.p_N = on_node(row.a, row.r_a);
  push.force = force.eigen();
  push.on_other = row.b;
  push.p_other = on_node(row.b, row.r_b);
  if (model_.is_ball(row.b)) {
    std::swap(push.node, push.on_other);
    std::swap(push.p_N, push.p_other);
    push.force = -push.force;
  }
  push.parts = contacts_.PartsOf(contacts_.pairs()[row.contact]);
  return push;
}

std::vector<ContactPush> RegionDynamics::ContactPushes() const {
  std::vector<ContactPush> pushes;
  const auto add = [&](const ContactParts& parts, const V3& p, const Vec3& force) {
    if (parts.link < 0) return;  // a ball that lies on something
    pushes.push_back({parts, p.eigen(), force});
    if (parts.by_link >= 0) pushes.push_back({parts.Swapped(), p.eigen(), -force});
  };
  const std::vector<ConstraintRow>& rows = rows_.rows();
  for (size_t k = 0; k < rows.size();) {
    const ConstraintRow& row = rows[k];
    if (!row.is_contact()) {
      ++k;
      continue;
    }
    Vec3 force = Vec3::Zero();
    do {  // a pair's rows follow one another
      force += row_forces_[static_cast<Eigen::Index>(k)] * rows[k].push.eigen();
    } while (++k < rows.size() && rows[k].contact == row.contact);
    add(contacts_.PartsOf(contacts_.pairs()[row.contact]), places_[row.a].p + row.r_a, force);
  }
  for (const FrozenForces::Push& push : frozen_.pushes) {
    const V3 r = FrozenForces::PointOn(kinematics_, push.node, push.p_N);
    const double sign = push.parts.by_ball >= 0 ? -1.0 : 1.0;  // it is on the ball
    add(push.parts, places_[push.node].p + r, sign * push.force);
  }
  return pushes;
}

}  // namespace hazumi
