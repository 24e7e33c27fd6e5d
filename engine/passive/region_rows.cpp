// Constraints of an island [METHOD 11]. With x_0 what forces and rules for accelerations give
// together, rows (J, c) of constraints that ask for J x + c = 0 get forces l:
//   x = x_0 + M^-1 J^T l,   (J M^-1 J^T + G) l = -(J x_0 + c)
// Rows that have a gap to close yield (RowYield): A + C instead of A, with C d on the right.
// G is what else gives way: in flight the centre of mass, by n n' / m for rows that push it along n
// and n'. Friction is in x_0, as if it were the torques M r. Rows that say the same twice share
// their force, the least there is.
// Gaps that a step leaves are closed by dy = -M^-1 J^T A^-1 e, rates by the same.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/passive/region_dynamics.h"
#include "engine/passive/semidefinite.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// What a row pushes the figure as a whole with.
V3 NetOf(const ConstraintRow& row) {
  if (row.turns || (row.a >= 0 && row.b >= 0)) return {};
  return row.a >= 0 ? row.n : -row.n;
}

}  // namespace

// J_ and G_, for rows that are measured and equations that are assembled.
void RegionDynamics::AssembleRows(const RegionLayout& layout) {
  const auto& motion = kinematics_.motion();
  const std::vector<ConstraintRow>& rows = rows_.rows();
  const auto count = static_cast<Eigen::Index>(rows.size());
  J_.setZero(layout.num_dofs(), count);  // a row a column
  G_.setZero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const ConstraintRow& row = rows[k];
    if (row.a >= 0) {
      dense_.AddToRow(layout, motion, row.a, motion[row.a].p + row.r_a, row.n, row.turns,
                      J_.col(k));
    }
    if (row.b >= 0) {
      dense_.AddToRow(layout, motion, row.b, motion[row.b].p + row.r_b, -row.n, row.turns,
                      J_.col(k));
    }
    if (model_.coupling != RootCoupling::kFlight) continue;
    for (Eigen::Index l = 0; l <= k; ++l) {
      G_(k, l) = G_(l, k) = Dot(NetOf(row), NetOf(rows[l])) / model_.mass;
    }
  }
}

// In the world, of a point of a node, r from its origin, with the root's acceleration known.
V3 RegionDynamics::AccelerationAt(int node, const V3& r, const V3& root) const {
  if (node < 0) return {};
  const NodeMotion& own = kinematics_.motion()[node];
  return root + own.a + Cross(own.alpha, r) + Cross(own.w, Cross(own.w, r));
}

// e'' less what it is to be, with accelerations x of the free joints, which are added to what the
// nodes move with.
VecX RegionDynamics::RowErrors(double t, const RegionLayout& layout, const double* x) {
  kinematics_.Accelerate(layout, x, 0);
  const auto& motion = kinematics_.motion();
  const V3 up(0.0, 0.0, gravity_);
  const V3 root = model_.coupling == RootCoupling::kFlight
                      ? V3(dense_.RootAcceleration(layout, motion, x)) - up
                      : BaseAcceleration(t) - up;
  const std::vector<ConstraintRow>& rows = rows_.rows();
  VecX errors(static_cast<Eigen::Index>(rows.size()));
  for (size_t k = 0; k < rows.size(); ++k) {
    const ConstraintRow& row = rows[k];
    V3 difference;
    if (row.turns) {
      if (row.a >= 0) difference += motion[row.a].alpha;
      if (row.b >= 0) difference -= motion[row.b].alpha;
    } else {
      difference = AccelerationAt(row.a, row.r_a, root) - AccelerationAt(row.b, row.r_b, root);
    }
    errors[static_cast<Eigen::Index>(k)] = Dot(row.n, difference) + row.bend - row.wanted;
  }
  return errors;
}

void RegionDynamics::KeepTogether(const RegionState& state, double* x) {
  const RegionLayout& layout = state.layout;
  rows_.Measure(state);
  if (rows_.rows().empty()) return row_forces_.resize(0);
  VecX errors = RowErrors(state.t, layout, x);
  AssembleRows(layout);
  J_answer_ = J_;
  for (Eigen::Index k = 0; k < J_.cols(); ++k) dense_.SolveMore(layout, J_answer_.col(k));
  MatX A = J_.transpose() * J_answer_ + G_;
  if (rows_.any_yielding()) {
    if (!is_any_locked())
      yield_ = YieldOf(rows_.rows(), A, rows_.Damping(), model_.mass, /*blocked=*/false);
    A += yield_.C;
    errors -= yield_.C * yield_.d;
  }
  row_forces_ = -LeastNorm(A, errors);
  Eigen::Map<VecX>(x, layout.num_dofs()) += J_answer_ * row_forces_;
}

// Takes those that have a gap to close, which act by no impulse, out of J_ and G_. Returns e' of
// the others, and 0.
VecX RegionDynamics::LeaveClosedRows() {
  VecX rates = VecX::Zero(J_.cols());
  for (Eigen::Index k = 0; k < J_.cols(); ++k) {
    const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
    if (row.is_closed) {
      rates[k] = row.rate;
      continue;
    }
    J_.col(k).setZero();
    G_.row(k).setZero();
    G_.col(k).setZero();
  }
  return rates;
}

// How rows yield where limits hold some hinges: as if they held none.
void RegionDynamics::YieldAsIfFree(double t, const double* y) {
  const VecX none = VecX::Constant(num_hinges(), std::numeric_limits<double>::infinity());
  VecX q = VecX::Zero(num_hinges()), qd = q;
  layout_.Unpack(y, -none, none, &q, &qd);
  Move(t, hinge_layout_, q.data(), qd.data());
  dense_.Assemble(hinge_layout_, &kinematics_.motion());
  rows_.Measure(StateAt(t, hinge_layout_, q.data(), qd.data()));
  AssembleRows(hinge_layout_);
  Yield(hinge_layout_);
}

// For rows that are assembled.
void RegionDynamics::Yield(const RegionLayout& layout) {
  VecX unused(layout.num_dofs());
  dense_.Solve(layout, unused.data());
  J_answer_ = J_;
  for (Eigen::Index k = 0; k < J_.cols(); ++k) dense_.SolveMore(layout, J_answer_.col(k));
  yield_ = YieldOf(rows_.rows(), J_.transpose() * J_answer_ + G_, rows_.Damping(), model_.mass,
                   /*blocked=*/true);
}

// As limits need them, at rates for impacts, with the accelerations of rules for forces.
void RegionDynamics::AssembleHingeRows(const RegionState& state) {
  rows_.Measure(state);
  VecX rules = VecX::Zero(num_hinges());
  AddRules(state, rules.data());
  AssembleRows(hinge_layout_);
  hinge_rows_ = {J_.transpose(), G_, RowErrors(state.t, hinge_layout_, rules.data())};
  if (rows_.any_yielding()) {
    Yield(hinge_layout_);
    hinge_rows_.G += yield_.C;
    hinge_rows_.c -= yield_.C * yield_.d;
  }
  const VecX rates = LeaveClosedRows();
  hinge_row_rates_ = {J_.transpose(), G_, rates};
}

Vec3 RegionDynamics::KickOf(const VecX& impulses) const {
  V3 sum;
  for (Eigen::Index k = 0; k < impulses.size(); ++k) {
    sum += impulses[k] * NetOf(rows_.rows()[static_cast<size_t>(k)]);
  }
  return sum.eigen() / model_.mass;
}

double RegionDynamics::CloseGaps(double t, double* y) {
  constexpr double kNone = 1e-12;
  constexpr int kMostTries = 8;
  const RegionState state = StateAt(t, layout_, y, y + layout_.num_positions());
  const int dofs = layout_.num_dofs();
  VecX change(dofs);
  double left = 0.0;
  for (int tries = 0;; ++tries) {
    ++evaluations_;
    SetAnchorOf(y);
    Move(t, layout_, state.positions, state.velocities);
    rows_.Measure(state);
    dense_.Assemble(layout_, &kinematics_.motion());
    dense_.Solve(layout_, change.data());
    AssembleRows(layout_);
    const VecX rates = LeaveClosedRows();
    VecX gaps = VecX::Zero(J_.cols());
    for (Eigen::Index k = 0; k < J_.cols(); ++k) {
      const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
      if (row.is_closed) gaps[k] = row.gap;
    }
    left = gaps.lpNorm<Eigen::Infinity>();
    J_answer_ = J_;
    for (Eigen::Index k = 0; k < J_.cols(); ++k) dense_.SolveMore(layout_, J_answer_.col(k));
    const MatX A = J_.transpose() * J_answer_ + G_;
    const bool is_last = left <= kNone || tries == kMostTries;
    const VecX push = -LeastNorm(A, is_last ? rates : gaps);
    change = J_answer_ * push;
    if (is_last) {
      Eigen::Map<VecX>(y + layout_.num_positions(), dofs) += change;
    } else {
      layout_.Turn(change, y);
    }
    if (is_pushed_in_flight()) {
      double* anchor = y + layout_.state_size() + (is_last ? 3 : 0);
      Eigen::Map<Vec3> moved(anchor);
      moved += KickOf(push);
    }
    if (is_last) return left;
  }
}

void RegionDynamics::AddRowForces() {
  for (size_t k = 0; k < rows_.rows().size(); ++k) {
    const ConstraintRow& row = rows_.rows()[k];
    const V3 force = row_forces_[static_cast<Eigen::Index>(k)] * row.n;
    if (row.turns) {
      if (row.a >= 0) kinematics_.AddTorque(row.a, force);
      if (row.b >= 0) kinematics_.AddTorque(row.b, -force);
    } else {
      if (row.a >= 0) kinematics_.AddForce(row.a, row.r_a, force);
      if (row.b >= 0) kinematics_.AddForce(row.b, row.r_b, -force);
    }
  }
}

// On nodes that move with velocities v.
double RegionDynamics::PowerOfRows(const std::vector<V3>& v) {
  kinematics_.ClearForces();
  AddRowForces();
  return PowerOnNodes(v);
}

}  // namespace hazumi
