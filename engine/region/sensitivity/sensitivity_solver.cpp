// Between events d/dt dx = D_x f dx (VariationalStep), at events dx+ = S dx- (EventTangent).

#include "engine/region/sensitivity/sensitivity_solver.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/region/sensitivity/state_tangent.h"

namespace hazumi {

namespace {

constexpr double kMostOutside = 1e-8;  // [rad]

}  // namespace

SensitivitySolver::SensitivitySolver(RegionDynamics* dynamics, const VecX& lower, const VecX& upper,
                                     const Tolerance& tolerance)
    : dynamics_(dynamics),
      lower_(lower),
      upper_(upper),
      solver_(dynamics, lower, upper),
      step_(dynamics, tolerance.derivative),
      event_(dynamics, lower, upper),
      before_{dynamics->layout(), dynamics->NewState(), VecX()} {
  HAZUMI_ASSERT(dynamics->model().coupling != RootCoupling::kFlight);
  HAZUMI_ASSERT(dynamics->outer_layout().size() == 0 && !dynamics->mode().any_rows());
  solver_.SetTolerance(tolerance.motion);
}

std::optional<SensitivityFailure> SensitivitySolver::Start(double t, double end,
                                                           const HingeState& state, const MatX& D) {
  HAZUMI_ASSERT(D.rows() == 2 * dynamics_->num_hinges() && state.pin_velocity.isZero(0.0));
  HAZUMI_ASSERT(!dynamics_->layout().is_any_locked());
  before_ = {dynamics_->layout(), state, VecX()};
  VecX y(dynamics_->state_size()), dy(dynamics_->state_size());
  dynamics_->Pack(state, y.data());
  dynamics_->Evaluate(t, y.data(), dy.data());
  const RegionLayout& layout = before_.layout;
  layout.UnpackAccelerations(dy.data() + layout.num_positions(), state.q, state.qd, &before_.qdd);
  X_ = DofsFromHinges(layout, state.q, state.qd) * D;
  one_sided_from_.assign(static_cast<size_t>(D.cols()), std::numeric_limits<double>::infinity());
  curves_start_ = t;
  curves_end_ = end;
  is_fixed_time_ = true;
  solver_.Start(t, state);
  return FindOutside();
}

void SensitivitySolver::Restart(double end) {
  curves_start_ = time();
  curves_end_ = end;
  is_fixed_time_ = true;
  solver_.Restart();
}

std::optional<SensitivityFailure> SensitivitySolver::AdvanceTo(double t) {
  using Cause = SensitivityFailure::Cause;
  while (time() < t - kSameTime) {
    if (const std::optional<ExactFailure> failure = solver_.Advance(t)) {
      return SensitivityFailure{Cause::kNoMotion, time(), failure->hinge};
    }
    if (const std::optional<SensitivityFailure> failure = Cross()) return failure;
    if (!step_.Advance(solver_.step_start(), time(), &solver_, &X_)) {
      return SensitivityFailure{Cause::kNotSmooth, solver_.step_start()};
    }
    before_ = {dynamics_->layout(), now(), solver_.Report(time()).qdd};
    if (const std::optional<SensitivityFailure> failure = FindOutside()) return failure;
  }
  return std::nullopt;
}

// The event between the latest two steps, or where the motion begins.
std::optional<SensitivityFailure> SensitivitySolver::Cross() {
  using Cause = SensitivityFailure::Cause;
  const double t = solver_.step_start();
  const AfterEvent after = BeginningOfStep();
  const bool at_fixed_time = std::exchange(is_fixed_time_, false);
  if (!HasChanged(after)) return std::nullopt;
  const std::optional<MatX> to_hinges =
      HingesFromDofs(before_.layout, before_.state.q, before_.state.qd);
  if (!to_hinges) return SensitivityFailure{Cause::kAtPole, t};
  const std::optional<EventJump> jump =
      event_.Find(t, curves_start_, curves_end_, before_, after, at_fixed_time);
  if (!jump) return SensitivityFailure{Cause::kImpact, t};
  const MatX D = *to_hinges * X_;
  if (jump->kind != LimitEvent::kNone && jump->hinge >= 0) {
    events_.push_back({t, jump->kind, jump->hinge, jump->rate});
  }
  NoteOneSided(t, *jump, at_fixed_time, D);
  X_ = jump->S * D;
  return std::nullopt;
}

// A hinge that begins at its limit hits it at once, or later if it begins further inside.
void SensitivitySolver::NoteOneSided(double t, const EventJump& jump, bool at_fixed_time,
                                     const MatX& D) {
  const bool hits_at_start = at_fixed_time && jump.kind == LimitEvent::kHit && jump.hinge >= 0;
  const Eigen::Index n = dynamics_->num_hinges();
  for (Eigen::Index c = 0; c < D.cols(); ++c) {
    bool is_one_sided = jump.is_one_sided && !D.col(c).isZero(0.0);
    for (const int i : jump.also_stopped) is_one_sided |= D(i, c) != 0.0 || D(n + i, c) != 0.0;
    if (!is_one_sided && !(hits_at_start && D(jump.hinge, c) != 0.0)) continue;
    double& from = one_sided_from_[static_cast<size_t>(c)];
    from = std::min(from, t);
  }
}

AfterEvent SensitivitySolver::BeginningOfStep() {
  AfterEvent after{dynamics_->layout(), before_.state, VecX(), VecX()};
  const double t = solver_.step_start();
  solver_.Sample(t, &after.state);
  VecX y(dynamics_->state_size()), dy(dynamics_->state_size());
  dynamics_->Pack(after.state, y.data());
  dynamics_->Evaluate(t, y.data(), dy.data());
  after.velocities = y.tail(after.layout.num_dofs());
  after.accelerations = dy.tail(after.layout.num_dofs());
  return after;
}

// Returns whether limits hold other hinges, or rates jump.
bool SensitivitySolver::HasChanged(const AfterEvent& after) const {
  constexpr double kJump = 1e-11;  // relative
  if (LockedHinges(after.layout) != LockedHinges(before_.layout)) return true;
  if (after.layout.num_dofs() == 0) return false;
  VecX y(after.layout.state_size());
  after.layout.Pack(before_.state.q, before_.state.qd, y.data());
  const VecX v = y.tail(after.layout.num_dofs());
  return (after.velocities - v).lpNorm<Eigen::Infinity>() >
         kJump * (1.0 + v.lpNorm<Eigen::Infinity>());
}

std::optional<SensitivityFailure> SensitivitySolver::FindOutside() const {
  const VecX& q = before_.state.q;
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    if (q[i] <= upper_[i] + kMostOutside && q[i] >= lower_[i] - kMostOutside) continue;
    return SensitivityFailure{SensitivityFailure::Cause::kOutside, time(), i};
  }
  return std::nullopt;
}

std::optional<MatX> SensitivitySolver::Derivatives() const {
  const std::optional<MatX> to_hinges =
      HingesFromDofs(before_.layout, before_.state.q, before_.state.qd);
  if (!to_hinges) return std::nullopt;
  return *to_hinges * X_;
}

}  // namespace hazumi
