// Constraints and contacts of an island [METHOD 11, 12]. With x_0 what forces and rules for
// accelerations give together, rows (J, c) that ask for J x + c = 0 get forces l, which push along
// P:
//   x = x_0 + M^-1 P^T l,   A l = -(J x_0 + c),   A = J M^-1 P^T + G
// P is J but for contacts that slide, whose forces lean backwards.
// Rows that have a gap to close yield (RowYield): A + C instead of A, with C d on the right.
// G is what else gives way: in flight the centre of mass, by n n' / m for rows that push it along n
// and n'. Friction is in x_0, as if it were the torques M r. Rows that say the same twice share
// their force, the least there is.
// Gaps that a step leaves are closed by dy = -M^-1 J^T A^-1 e, rates by the same, with P = J.
// Articulated bodies tell half of J M^-1 J^T, in flight with the centre of mass, without M.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/passive/region_dynamics.h"
#include "engine/passive/semidefinite.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

bool slides(const ConstraintRow& row) {
  return row.is_contact() &&
         (row.push.x != row.n.x || row.push.y != row.n.y || row.push.z != row.n.z);
}

}  // namespace

void RegionDynamics::MeasureRows(const RegionState& state) {
  rows_.Measure(state);
  contacts_.AppendRows(state, rows_.mutable_rows());
}

// What x does to the acceleration of a row's ends along n; by bodies, half of it.
void RegionDynamics::AddToRow(const RegionLayout& layout, const ConstraintRow& row, const V3& n,
                              Eigen::Ref<VecX> column) const {
  const auto& motion = kinematics_.motion();
  const auto add = [&](int node, const V3& r, const V3& along) {
    if (node < 0 || model_.is_ball(node)) return;
    if (by_bodies_) {
      tree_.bodies().AddHalf(layout, motion, node, r, along, row.turns, column.data());
    } else {
      dense_.AddToRow(layout, motion, node, motion[node].p + r, along, row.turns, column);
    }
  };
  add(row.a, row.r_a, n);
  add(row.b, row.r_b, -n);
}

// J_, G_ and, where contacts slide, P_, for rows that are measured and equations that are
// assembled or solved by bodies.
void RegionDynamics::AssembleRows(const RegionLayout& layout) {
  const std::vector<ConstraintRow>& rows = rows_.rows();
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (by_bodies_) tree_.bodies().FactorJoints(layout, kinematics_.motion());
  J_.setZero((by_bodies_ ? tree_.bodies().num_root() : 0) + layout.num_dofs(), count);
  for (Eigen::Index k = 0; k < count; ++k) {  // a row a column
    AddToRow(layout, rows[k], rows[k].n, J_.col(k));
  }
  any_slides_ = std::any_of(rows.begin(), rows.end(), slides);
  if (any_slides_) {
    P_ = J_;
    for (Eigen::Index k = 0; k < count; ++k) {
      if (slides(rows[k])) AddToRow(layout, rows[k], rows[k].push - rows[k].n, P_.col(k));
    }
  }
  G_.setZero(count, count);
  if (!model_.balls.empty()) LetBallsAnswer();
  if (by_bodies_) return;
  Eigen::Matrix3Xd moves(3, count), pushes(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    moves.col(k) = NetOf(rows[k], rows[k].n);
    pushes.col(k) = NetOf(rows[k], rows[k].force());
  }
  if (any_slides_) dense_.AddRootToRows(layout, pushes, P_);
  dense_.AddRootToRows(layout, moves, J_);
  if (model_.coupling != RootCoupling::kFlight) return;
  G_.noalias() += moves.transpose().lazyProduct(pushes / model_.mass);
}

// What the rows do to each other, by way of the joints, whose equations are solved: with M = R R^T
//   A = (R^-1 J^T)^T R^-1 P^T + G
MatX RegionDynamics::AnswerRows(const RegionLayout& layout) {
  half_answer_ = any_slides_ ? P_ : J_;
  if (by_bodies_) return ProductOf(any_slides_ ? J_ : half_answer_, half_answer_) + G_;
  dense_.SolveLower(layout, half_answer_);
  if (!any_slides_) return ProductOf(half_answer_, half_answer_) + G_;
  MatX J = J_;
  dense_.SolveLower(layout, J);
  return ProductOf(J, half_answer_) + G_;
}

// After it: what pushes of the rows do to the joints.
VecX RegionDynamics::AnswerOfRows(const RegionLayout& layout, const VecX& pushes) {
  VecX half = half_answer_ * pushes;
  if (!by_bodies_) {
    dense_.SolveUpper(layout, half);
    return half;
  }
  VecX x(layout.num_dofs());
  tree_.bodies().FinishHalf(layout, kinematics_.motion(), half.data(), x.data());
  return x;
}

// A l = -errors. Contacts, of which a body may have many more than it has directions to move in,
// give way by next to nothing, which is faster than the least norm.
VecX RegionDynamics::SolveRows(const MatX& A, const VecX& errors) const {
  if (!contacts_.any_closed()) return -LeastNorm(A, errors);
  return SolveGivingWay(A, !any_slides_ && !rows_.any_yielding(), -errors, Softness());
}

// Of rows across contacts: less where more pushes, so that they share a drag as their cones do.
VecX RegionDynamics::Softness() const {
  constexpr double kLeast = 0.01;
  const std::vector<ConstraintRow>& rows = rows_.rows();
  VecX softness = VecX::Ones(static_cast<Eigen::Index>(rows.size()));
  double most = 0.0;
  for (const ContactPair& pair : contacts_.pairs()) {
    if (pair.mode == ContactMode::kStick) most = std::max(most, pair.load);
  }
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].is_contact()) continue;
    const ContactPair& pair = contacts_.pairs()[rows[k].contact];
    if (pair.mode != ContactMode::kStick) continue;
    const double share = most > 0.0 ? std::max(kLeast, pair.load / most) : 1.0;
    softness.segment<2>(static_cast<Eigen::Index>(k) + 1).setConstant(1.0 / share);
    k += 2;
  }
  return softness;
}

// Rows are scaled by the firmest one of their constraint, points and turns apart; distances, of one
// row each, by the firmest of all.
std::vector<RegionDynamics::Hold> RegionDynamics::Holds() const {
  const std::vector<ConstraintRow>& rows = rows_.rows();
  std::vector<size_t> closed;
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].is_contact() && rows[k].is_closed) closed.push_back(k);
  }
  std::vector<Hold> holds;
  if (closed.empty() || half_answer_.cols() != J_.cols()) return holds;
  const MatX half = half_answer_(Eigen::all, closed);
  const MatX A = ProductOf(half, half) + G_(closed, closed);
  VecX unit(A.rows());
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    double firmest = 0.0;
    int others = 0;
    for (Eigen::Index l = 0; l < A.rows(); ++l) {
      const ConstraintRow &own = rows[closed[k]], &other = rows[closed[l]];
      if (other.constraint != own.constraint || other.turns != own.turns) continue;
      firmest = std::max(firmest, A(l, l));
      others += l != k;
    }
    if (others == 0) firmest = A.diagonal().maxCoeff();
    unit[k] = firmest > 0.0 ? 1.0 / std::sqrt(firmest) : 0.0;
  }
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(unit.asDiagonal() * A * unit.asDiagonal());
  for (Eigen::Index k = 0; k < unit.size(); ++k) {
    Eigen::Index most = 0;
    eigen.eigenvectors().col(k).cwiseAbs().maxCoeff(&most);
    holds.push_back({eigen.eigenvalues()[k], rows[closed[most]].constraint});
  }
  return holds;
}

// In the world, of a point of a node, r from its origin, with the root's acceleration known.
V3 RegionDynamics::AccelerationAt(int node, const V3& r, const V3& root) const {
  if (node < 0) return {};
  const NodeMotion& own = kinematics_.motion()[node];
  const V3 a = model_.is_ball(node) ? own.a : root + own.a;
  return a + Cross(own.alpha, r) + Cross(own.w, Cross(own.w, r));
}

// After the nodes have been accelerated by x, less gravity's.
V3 RegionDynamics::RootAcceleration(double t, const RegionLayout& layout, const double* x) const {
  const V3 up(0.0, 0.0, gravity_);
  if (model_.coupling != RootCoupling::kFlight) return BaseAcceleration(t) - up;
  if (by_bodies_) return (-1.0 / model_.mass) * kinematics_.AskedForce() - up;
  return V3(dense_.RootAcceleration(layout, kinematics_.motion(), x)) - up;
}

// e'' less what it is to be, with accelerations x of the free joints, which are added to what the
// nodes move with.
VecX RegionDynamics::RowErrors(double t, const RegionLayout& layout, const double* x) {
  kinematics_.Accelerate(layout, x, 0);
  const auto& motion = kinematics_.motion();
  const V3 root = RootAcceleration(t, layout, x);
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
  MeasureRows(state);
  if (rows_.rows().empty()) return row_forces_.resize(0);
  VecX errors = RowErrors(state.t, layout, x);
  AssembleRows(layout);
  MatX A = AnswerRows(layout);
  if (rows_.any_yielding()) {
    if (!is_any_locked()) {
      yield_ = YieldOf(rows_.rows(), A, rows_.Damping(), model_.mass, least_yield_);
    }
    A += yield_.C;
    errors -= yield_.C * yield_.d;
  }
  row_forces_ = SolveRows(A, errors);
  Eigen::Map<VecX>(x, layout.num_dofs()) += AnswerOfRows(layout, row_forces_);
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
  by_bodies_ = false;
  MeasureRows(StateAt(t, hinge_layout_, q.data(), qd.data()));
  AssembleRows(hinge_layout_);
  Yield(hinge_layout_);
}

// For rows that are assembled.
void RegionDynamics::Yield(const RegionLayout& layout) {
  VecX unused(layout.num_dofs());
  dense_.Solve(layout, unused.data());
  yield_ = YieldOf(rows_.rows(), AnswerRows(layout), rows_.Damping(), model_.mass, least_yield_);
}

// As limits need them, at rates for impacts, with the accelerations of rules for forces.
void RegionDynamics::AssembleHingeRows(const RegionState& state) {
  MeasureRows(state);
  VecX rules = VecX::Zero(num_hinges());
  AddRules(state, rules.data());
  AssembleRows(hinge_layout_);
  hinge_rows_ = {J_.transpose(), G_, RowErrors(state.t, hinge_layout_, rules.data()), {}, {}};
  if (any_slides_) hinge_rows_.P = P_.transpose();
  if (contacts_.any_closed()) hinge_rows_.softness = Softness();
  if (rows_.any_yielding()) {
    Yield(hinge_layout_);
    hinge_rows_.G += yield_.C;
    hinge_rows_.c -= yield_.C * yield_.d;
  }
  const VecX rates = LeaveClosedRows();
  hinge_row_rates_ = {J_.transpose(), G_, rates, hinge_rows_.P, hinge_rows_.softness};
}

double RegionDynamics::CloseGaps(double t, double* y, bool only_looked_at) {
  constexpr double kNone = 1e-12;
  constexpr int kMostTries = 8;
  const RegionState state = StateAt(t, layout_, y, y + layout_.num_positions());
  const int dofs = layout_.num_dofs();
  VecX change(dofs);
  double left = 0.0;
  for (int tries = 0;; ++tries) {
    ++evaluations_;
    SetOuterOf(y);
    Move(t, layout_, state.positions, state.velocities);
    MeasureRows(state);
    for (ConstraintRow& row : *rows_.mutable_rows()) row.push = row.n;  // nothing slides here
    SolveWithoutRows(layout_, change.data());
    AssembleRows(layout_);
    const VecX rates = LeaveClosedRows();
    VecX gaps = VecX::Zero(J_.cols());
    for (Eigen::Index k = 0; k < J_.cols(); ++k) {
      const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
      if (row.is_closed) gaps[k] = row.gap;
    }
    left = gaps.lpNorm<Eigen::Infinity>();
    const MatX A = AnswerRows(layout_);
    const bool is_last = left <= kNone || tries == kMostTries;
    const VecX push = SolveRows(A, is_last ? rates : gaps);
    change = AnswerOfRows(layout_, push);
    if (is_last) {
      Eigen::Map<VecX>(y + layout_.num_positions(), dofs) += change;
    } else {
      layout_.Turn(change, y);
    }
    if (outer_layout_.size() > 0) {
      double* outer = y + layout_.state_size();
      is_last ? outer_layout_.Jump(KickOf(push), outer) : outer_layout_.MoveOn(KickOf(push), outer);
    }
    if (is_last) return LowerFloors(gaps, only_looked_at);
  }
}

// Where there is no room contacts yield: what is left of their gaps is theirs from now on. Returns
// the largest of the others.
double RegionDynamics::LowerFloors(const VecX& gaps, bool only_looked_at) {
  double left = 0.0;
  for (Eigen::Index k = 0; k < gaps.size(); ++k) {
    const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
    if (!row.is_contact()) {
      left = std::max(left, std::abs(gaps[k]));
    } else if (gaps[k] != 0.0 && !only_looked_at) {
      contacts_.SetFloor(row.contact, contacts_.pairs()[row.contact].floor + gaps[k]);
    }
  }
  return left;
}

void RegionDynamics::AddRowForces(RowsOf of) {
  for (size_t k = 0; k < rows_.rows().size(); ++k) {
    const ConstraintRow& row = rows_.rows()[k];
    if (of != RowsOf::kAll && row.is_contact() != (of == RowsOf::kContacts)) continue;
    const V3 force = row_forces_[static_cast<Eigen::Index>(k)] * row.force();
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
double RegionDynamics::PowerOfRows(RowsOf of, const std::vector<V3>& v) {
  kinematics_.ClearForces();
  AddRowForces(of);
  return PowerOnNodes(v);
}

}  // namespace hazumi
