// With M x = -b + P^T l for hinges, rows w = J x + c + G l, and a row -side for each hinge at a
// limit, all of them are
//   w = A l + (J x_0 + c),   A = J M^-1 P^T + G,   M x_0 = -b
// for accelerations; the same for rates, with x their jump and c the velocities before.

#include "engine/passive/exact/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "engine/passive/semidefinite.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

using Kind = ConeProblem::Kind;

// Of the largest acceleration there would be without the forces: less is none.
constexpr double kNone = 1e-9, kStill = 1e-4;

}  // namespace

ContactForces::ContactForces(RegionDynamics* dynamics) : dynamics_(dynamics) {
  T_.setZero(dynamics->num_hinges());
}

bool ContactForces::FindTouching(double t, const VecX& q, const VecX& qd) {
  ContactSet& contacts = dynamics_->contacts();
  const RegionState state = dynamics_->PlaceHinges(t, q, qd);
  contacts.FindPairs(state, 1e-3 + touch_);
  touching_.clear();
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    contacts.SetMode(i, ContactMode::kOpen);
    const auto point = contacts.PointOf(i, state);
    if (point && point->gap <= contacts.pairs()[i].floor + touch_) touching_.push_back(i);
  }
  return !touching_.empty();
}

void ContactForces::Impact(double t, const VecX& q, const Vec3& v_pin, const std::vector<int>& side,
                           const std::vector<char>& sticks, VecX* qd) {
  for (const int i : touching_) dynamics_->contacts().SetMode(i, ContactMode::kStick);
  dynamics_->AssembleHinges(t, q, *qd);
  Factor();
  VecX jump = VecX::Zero(qd->size());
  if (!v_pin.isZero(0.0)) {
    dynamics_->PinImpulse(v_pin, &jump);
    SolveSemidefinite(L_, jump);
  }
  LimitRows rows = *dynamics_->RowsOfImpulses();
  // Limits feel rates, not their jump.
  rows.c += rows.J * jump;
  *qd += jump;
  SetUp(side, sticks, rows, *qd);
  Solve();
  *qd += answer_ * forces_;
  for (size_t k = 0; k < limits_.size(); ++k) {
    const auto row = l_.size() + static_cast<Eigen::Index>(k);
    if (forces_[row] > 0.0 || sticks[limits_[k]]) (*qd)[limits_[k]] = 0.0;
  }
}

// The problem, with x_0 for limits alone.
void ContactForces::SetUp(const std::vector<int>& side, const std::vector<char>& sticks,
                          const LimitRows& rows, const VecX& x_0) {
  limits_.clear();
  for (int i = 0; i < static_cast<int>(side.size()); ++i) {
    if (side[i] != 0) limits_.push_back(i);
  }
  const Eigen::Index n = x_0.size(), own = rows.c.size();
  const Eigen::Index count = own + static_cast<Eigen::Index>(limits_.size());
  MatX J = MatX::Zero(n, count);
  answer_.setZero(n, count);
  J.leftCols(own) = rows.J.transpose();
  answer_.leftCols(own) = rows.push().transpose();
  problem_.b.resize(count);
  problem_.b.head(own) = rows.c;
  for (Eigen::Index k = own; k < count; ++k) {
    const int hinge = limits_[k - own];
    J(hinge, k) = answer_(hinge, k) = -side[hinge];
    problem_.b[k] = -side[hinge] * x_0[hinge];
  }
  for (Eigen::Index k = 0; k < count; ++k) SolveSemidefinite(L_, answer_.col(k));
  problem_.A = J.transpose() * answer_;
  problem_.A.topLeftCorner(own, own) += rows.G;
  problem_.blocks.clear();
  const std::vector<ConstraintRow>& all = dynamics_->rows();
  for (int k = 0; k < static_cast<int>(own); ++k) {
    if (!all[k].is_contact()) {
      problem_.blocks.push_back({Kind::kBoth, k});
      continue;
    }
    const bool sticks_there =
        dynamics_->contacts().pairs()[all[k].contact].mode == ContactMode::kStick;
    const double friction = dynamics_->contacts().FrictionOf(all[k].contact);
    problem_.blocks.push_back({sticks_there ? Kind::kContact : Kind::kPush, k, friction});
    if (sticks_there) k += 2;
  }
  for (Eigen::Index k = own; k < count; ++k) {
    const bool both = sticks[limits_[k - own]];
    problem_.blocks.push_back({both ? Kind::kBoth : Kind::kPush, static_cast<int>(k)});
  }
}

bool ContactForces::Solve() {
  const bool is_solved = SolveCones(problem_, &forces_);
  l_ = forces_.head(forces_.size() - static_cast<Eigen::Index>(limits_.size()));
  return is_solved;
}

void ContactForces::Factor() {
  L_ = dynamics_->M();
  FactorSemidefinite(L_);
}

// x_0, and the rows with what they would do under it.
LimitRows ContactForces::Unheld(VecX* x_0) {
  Factor();
  *x_0 = -dynamics_->b();
  SolveSemidefinite(L_, *x_0);
  LimitRows rows;
  rows.J.resize(0, x_0->size());
  if (const LimitRows* known = dynamics_->RowsOfForces()) rows = *known;
  if (rows.c.size() > 0) rows.c += rows.J * *x_0;
  return rows;
}

void ContactForces::Freeze(double t, const VecX& q, const VecX& qd, const LimitRange& limits,
                           double h) {
  constexpr double kReach = 0.1;   // of hinges to their limits [rad]
  constexpr double kWayOut = 0.1;  // of what is inside, comes out in this time
  ContactSet& contacts = dynamics_->contacts();
  FrozenForces& frozen = dynamics_->frozen();
  frozen.Clear();
  const RegionState state = dynamics_->PlaceHinges(t, q, qd);
  const double reach = 2.0 * h * contacts.FastestEnd(state) + 1e-4;
  contacts.FindPairs(state, reach);
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    const auto point = contacts.PointOf(i, state);
    const bool is_near = point && point->gap <= reach;
    contacts.SetMode(i, is_near ? ContactMode::kStick : ContactMode::kOpen);
  }
  std::vector<int> side(static_cast<size_t>(q.size()), 0);
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    const double up = -limits.Beyond(i, 1, q[i]), down = -limits.Beyond(i, -1, q[i]);
    if (limits.is_fixed(i)) continue;
    if (std::min(up, down) < kReach) side[i] = up < down ? 1 : -1;
  }
  dynamics_->AssembleHinges(t, q, qd);
  VecX x_0;
  LimitRows rows = Unheld(&x_0);
  rows.c *= h;
  const std::vector<ConstraintRow>& all = dynamics_->rows();
  for (Eigen::Index k = 0; k < rows.c.size(); ++k) {
    const ConstraintRow& row = all[k];
    if (!row.is_contact()) continue;
    rows.c[k] += row.rate;
    if (row.gap != 0.0) rows.c[k] += (row.gap > 0.0 ? 1.0 : kWayOut) * row.gap / h;
  }
  SetUp(side, std::vector<char>(side.size(), 0), rows, qd + h * x_0);
  for (size_t k = 0; k < limits_.size(); ++k) {
    const int i = limits_[k];
    problem_.b[rows.c.size() + static_cast<Eigen::Index>(k)] -= limits.Beyond(i, side[i], q[i]) / h;
  }
  Solve();
  for (Eigen::Index k = 0; k < l_.size(); ++k) {
    const ConstraintRow& row = all[k];
    if (!row.is_contact() || l_[k] == 0.0) continue;
    const M3& R = state.kinematics.motion()[row.a].R;
    const V3 force = (l_[k] / h) * row.push;
    frozen.pushes.push_back({row.a, TransposeTimes(R, row.r_a).eigen(), force.eigen()});
  }
  VecX torques = VecX::Zero(q.size());
  for (size_t k = 0; k < limits_.size(); ++k) {
    const int i = limits_[k];
    torques[i] = -side[i] * forces_[l_.size() + static_cast<Eigen::Index>(k)] / h;
  }
  dynamics_->Freeze(torques);
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    contacts.SetMode(i, ContactMode::kOpen);
  }
}

void ContactForces::Close(int pair, const TouchPoint& point, bool may_slide) {
  ContactSet& contacts = dynamics_->contacts();
  contacts.SetFloor(pair, point.gap);
  const V3 across = point.v - Dot(point.n, point.v) * point.n;
  const double speed = std::sqrt(Dot(across, across));
  if (contacts.FrictionOf(pair) == 0.0) {
    contacts.Slide(pair, V3());
  } else if (may_slide && speed > kSlowSlide) {
    contacts.Slide(pair, (1.0 / speed) * across);
  } else {
    contacts.SetMode(pair, ContactMode::kStick);
  }
}

void ContactForces::Rest(double t, const VecX& q, const VecX& qd, const std::vector<int>& side,
                         const std::vector<char>& fixed, std::vector<char>* held) {
  ContactSet& contacts = dynamics_->contacts();
  // Where sliding has no solution (Painleve), what touches is stopped by the force it takes.
  for (const bool may_slide : {true, false}) {
    const RegionState state = dynamics_->PlaceHinges(t, q, qd);
    for (const int i : touching_) {
      const auto point = contacts.PointOf(i, state);
      if (point && Dot(point->n, point->v) <= rest_speed_) {
        Close(i, *point, may_slide);
      } else {
        contacts.SetMode(i, ContactMode::kOpen);
      }
    }
    dynamics_->AssembleHinges(t, q, qd);
    VecX x_0;
    const LimitRows rows = Unheld(&x_0);
    SetUp(side, fixed, rows, x_0);
    if (Solve()) break;
  }
  SetModes();
  T_.setZero();
  std::fill(held->begin(), held->end(), 0);
  for (size_t k = 0; k < limits_.size(); ++k) {
    const int hinge = limits_[k];
    const auto row = l_.size() + static_cast<Eigen::Index>(k);
    const double force = forces_[row];
    (*held)[hinge] = fixed[hinge] || IsFelt(row);
    T_[hinge] = -side[hinge] * force;
  }
}

// Whether what a row pushes with changes anything.
bool ContactForces::IsFelt(Eigen::Index row) const {
  return forces_[row] * problem_.A(row, row) > kNone * problem_.b.lpNorm<Eigen::Infinity>();
}

void ContactForces::SetModes() {
  ContactSet& contacts = dynamics_->contacts();
  const std::vector<ConstraintRow>& all = dynamics_->rows();
  const VecX w = problem_.A * forces_ + problem_.b;
  const double unheld = problem_.b.size() > 0 ? problem_.b.lpNorm<Eigen::Infinity>() : 0.0;
  for (const ConeProblem::Block& block : problem_.blocks) {
    if (block.row >= l_.size() || block.kind == Kind::kBoth) continue;
    const ConstraintRow& row = all[block.row];
    const double push = l_[block.row];
    if (!IsFelt(block.row)) {
      contacts.SetMode(row.contact, ContactMode::kOpen);
      continue;
    }
    if (block.kind == Kind::kPush) continue;
    contacts.SetLoad(row.contact, push);
    // Points of one body share what holds them in more ways than one: those that do not begin to
    // move stick, however near to its cone a force is.
    const Eigen::Vector2d moves = w.segment<2>(block.row + 1);
    const double size = moves.norm();
    if (size <= kStill * unheld) continue;
    contacts.Slide(row.contact, (moves[0] / size) * all[block.row + 1].n +
                                    (moves[1] / size) * all[block.row + 2].n);
  }
}

}  // namespace hazumi
