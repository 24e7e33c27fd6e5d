// An impact is inelastic, with impulses p. Where there is a restitution e a second phase follows
// [Poisson]: n e p_n, and across it what friction makes of it, |t| <= mu e p_n, against what still
// slides; and, where that pushes something in elsewhere, an inelastic impact of that.

#include "engine/region/exact/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "engine/matrix/semidefinite.h"
#include "engine/region/exact/impact_log.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

using Kind = ConeProblem::Kind;

// Of the largest acceleration there would be without the forces: less is none.
constexpr double kNoForce = 1e-9, kStill = 1e-4;
// What would be back within so long does not bounce [s]: else it would do so for ever.
constexpr double kShortHop = 6e-3;
constexpr int kMostHalvings = 30;
// Factor between touch_ and a gap that may count as touching in another solution.
constexpr double kUnsure = 10.0;

// Contacts that approach so slowly that it is rounding do not approach. Where friction wedges one,
// an impulse that stops it is a solution, too, however slow it is. `velocities`: of the rows [m/s].
void ForgetRounding(const std::vector<ConstraintRow>& rows, VecX* velocities) {
  constexpr double kRounding = 1e-12;  // of the velocity across the normal
  const Eigen::Index count = velocities->size();
  for (Eigen::Index k = 0; k < count; ++k) {
    const ConstraintRow& row = rows[static_cast<size_t>(k)];
    double& along = (*velocities)[k];
    if (!row.is_contact() || row.is_across || along >= 0.0) continue;
    double across = 0.0;
    for (Eigen::Index i = k + 1; i < count && rows[static_cast<size_t>(i)].is_across; ++i) {
      across = std::hypot(across, (*velocities)[i]);
    }
    if (along >= -kRounding * across) along = 0.0;
  }
}

}  // namespace

ContactForces::ContactForces(RegionDynamics* dynamics) : dynamics_(dynamics), problem_(dynamics) {
  T_.setZero(dynamics->num_hinges());
}

bool ContactForces::FindTouching(double t, const HingeState& at) {
  ContactSet& contacts = dynamics_->mode().contacts;
  const RegionState state = dynamics_->PlaceHinges(t, at);
  contacts.FindPairs(state, 1e-3 + touch_);
  contacts.OpenAll();
  touching_.clear();
  is_order_unsure_ = false;
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    const auto point = contacts.PointOf(i, state);
    if (!point) continue;
    const double gap = point->gap - contacts.pairs()[i].allowed_gap;
    if (gap <= touch_) touching_.push_back(i);
    const bool is_near = gap > touch_ / kUnsure && gap < touch_ * kUnsure;
    is_order_unsure_ |= is_near && Dot(point->n, point->v) < -kTouchDownSpeed;
  }
  return !touching_.empty();
}

void ContactForces::Impact(double t, const std::vector<int>& side, const std::vector<char>& sticks,
                           HingeState* state) {
  for (const int i : touching_) dynamics_->mode().contacts.SetMode(i, ContactMode::kStick);
  const HingeEquations equations = dynamics_->AssembleHinges(t, *state);
  problem_.Factor(equations.M());
  VecX& qd = state->qd;
  VecX jump = VecX::Zero(qd.size());
  if (equations.stops_pin()) {
    equations.StopPin(&jump);
    SolveSemidefinite(problem_.factor(), jump);
  }
  LimitRows rows = *equations.for_impulses();
  // Limits respond to rates, not to their change.
  rows.c += rows.J * jump;
  if (dynamics_->mode().contacts.rules().tells_motion_from_rounding) {
    ForgetRounding(dynamics_->rows().rows(), &rows.c);
  }
  qd += jump;
  problem_.SetUp(side, sticks, rows, qd);
  has_solved_impact_ = Solve();
  Bounce(rows.c);
  ListStruck(rows.c);
  const VecX before = qd;
  work_ = problem_.Gain();
  qd += problem_.Answer();
  limit_work_ = problem_.WorkOfLimits(side, before, qd);
  for (size_t k = 0; k < problem_.limits().size(); ++k) {
    const int hinge = problem_.limits()[k];
    if (problem_.forces()[problem_.RowOfLimit(k)] > 0.0 || sticks[hinge]) qd[hinge] = 0.0;
  }
}

void ContactForces::ListStruck(const VecX& came) {
  struck_.clear();
  for (const ConeProblem::Block& block : problem_.cones().blocks) {
    if (block.kind != Kind::kContact || came[block.row] > -kTouchDownSpeed) continue;
    if (problem_.forces()[block.row] <= 0.0) continue;
    struck_.push_back(dynamics_->rows().rows()[static_cast<size_t>(block.row)].contact);
  }
}

// `came`: the rows' velocities before the impact.
void ContactForces::Bounce(const VecX& came) {
  VecX more = ImpulsesOfBounce(came);
  if (more.size() == 0) return;
  const VecX first = problem_.forces();
  const double slack = kNoForce * std::abs(problem_.cones().b.dot(first));
  // Where things are wedged by friction all of it might give more than there was.
  for (int i = 0; i < kMostHalvings; ++i, more *= 0.5) {
    problem_.SolveBeside(first + more);
    if (problem_.Gain() <= slack) break;
  }
  l_ = problem_.row_forces();
}

// Of the second phase; none: nothing bounces.
VecX ContactForces::ImpulsesOfBounce(const VecX& came) const {
  constexpr int kMostSweeps = 200;
  constexpr double kEnough = 1e-14;  // of the largest
  const ContactSet& contacts = dynamics_->mode().contacts;
  const ConeProblem& cones = problem_.cones();
  const double slow = 0.5 * kShortHop * dynamics_->gravity();
  VecX more = VecX::Zero(cones.b.size());
  for (const ConeProblem::Block& block : cones.blocks) {
    if (block.kind != Kind::kContact || came[block.row] > -slow) continue;
    const double restitution =
        contacts.RestitutionOf(dynamics_->rows().rows()[static_cast<size_t>(block.row)].contact);
    more[block.row] = restitution * problem_.forces()[block.row];
  }
  const double largest = more.lpNorm<Eigen::Infinity>();
  if (largest == 0.0) return {};
  const VecX w = cones.A * problem_.forces() + cones.b;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (const ConeProblem::Block& block : cones.blocks) {
      if (block.kind != Kind::kContact || more[block.row] == 0.0) continue;
      const Eigen::Index i = block.row + 1;
      const double answer =
          std::max(cones.A(i, i), cones.A(i + 1, i + 1)) + std::abs(cones.A(i, i + 1));
      const Eigen::Vector2d v = w.segment<2>(i) + cones.A.middleRows<2>(i) * more;
      Eigen::Vector2d across = more.segment<2>(i);
      if (answer > 0.0) across -= v / answer;
      const double most = block.friction * more[block.row], size = across.norm();
      if (size > most) across *= most / size;
      change = std::max(change, (across - more.segment<2>(i)).norm());
      more.segment<2>(i) = across;
    }
    if (change <= kEnough * largest) break;
  }
  return more;
}

bool ContactForces::Solve() {
  const bool is_solved = problem_.Solve();
  l_ = problem_.row_forces();
  return is_solved;
}

void ContactForces::Close(int pair, const TouchPoint& point, bool may_slide) {
  ContactSet& contacts = dynamics_->mode().contacts;
  contacts.AllowGap(pair, point.gap);
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

void ContactForces::Rest(double t, const HingeState& at, const std::vector<int>& side,
                         const std::vector<char>& fixed, std::vector<char>* held) {
  ContactSet& contacts = dynamics_->mode().contacts;
  // Where sliding has no solution (Painleve), what touches is stopped by the force it takes.
  for (const bool may_slide : {true, false}) {
    const RegionState state = dynamics_->PlaceHinges(t, at);
    for (const int i : touching_) {
      const auto point = contacts.PointOf(i, state);
      if (point && Dot(point->n, point->v) <= rest_speed_) {
        Close(i, *point, may_slide);
      } else {
        contacts.SetMode(i, ContactMode::kOpen);
      }
    }
    const HingeEquations equations = dynamics_->AssembleHinges(t, at);
    problem_.Factor(equations.M());
    VecX x_0;
    const LimitRows rows = problem_.Unheld(equations, equations.b(), &x_0);
    problem_.SetUp(side, fixed, rows, x_0);
    if (Solve()) break;
  }
  SetModes();
  T_.setZero();
  std::fill(held->begin(), held->end(), 0);
  for (size_t k = 0; k < problem_.limits().size(); ++k) {
    const int hinge = problem_.limits()[k];
    const Eigen::Index row = problem_.RowOfLimit(k);
    const double force = problem_.forces()[row];
    (*held)[hinge] = fixed[hinge] || IsFelt(row);
    T_[hinge] = -side[hinge] * force;
  }
}

// Whether what a row pushes with changes anything.
bool ContactForces::IsFelt(Eigen::Index row) const {
  const ConeProblem& cones = problem_.cones();
  return problem_.forces()[row] * cones.A(row, row) > kNoForce * cones.b.lpNorm<Eigen::Infinity>();
}

void ContactForces::SetModes() {
  ContactSet& contacts = dynamics_->mode().contacts;
  const std::vector<ConstraintRow>& all = dynamics_->rows().rows();
  const ConeProblem& cones = problem_.cones();
  const VecX w = cones.A * problem_.forces() + cones.b;
  const double unheld = cones.b.size() > 0 ? cones.b.lpNorm<Eigen::Infinity>() : 0.0;
  for (const ConeProblem::Block& block : cones.blocks) {
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
