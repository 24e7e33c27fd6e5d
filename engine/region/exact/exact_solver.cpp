#include "engine/region/exact/exact_solver.h"

#include <algorithm>
#include <utility>

#include "engine/base/root.h"
#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

// From the first start on, so that what cannot be solved ends within five seconds.
constexpr double kMostWork = 6e5, kMostWorkPerSecond = 2e6;  // in evaluations

}  // namespace

ExactSolver::ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper)
    : dynamics_(dynamics),
      range_(std::move(lower), std::move(upper)),
      step_(dynamics, &range_),
      held_(dynamics, &range_),
      hit_search_(dynamics, &range_, &step_),
      release_search_(dynamics, &step_, &held_),
      contact_search_(dynamics, &step_),
      kink_search_(dynamics, &step_),
      time_stepping_(dynamics, &range_),
      switch_(dynamics, &held_, &time_stepping_),
      log_(dynamics->num_hinges()) {}

void ExactSolver::Start(double t, const HingeState& state) {
  HAZUMI_ASSERT(state.q.size() == dynamics_->num_hinges() && IsFinite(state.q) &&
                IsFinite(state.qd));
  if (steps_ == 0) first_start_ = t;
  step_.Place(t, state);
  step_.now().pin_velocity.setZero();
  range_.Begin(state.q);
  held_.Begin();
  time_stepping_.Begin();
  switch_.BeginEvents(t, steps_);
  step_end_.reset();
  release_search_.Begin();
  switch_.EntersAtStart(t, step_.now()) ? StepInTime() : Resolve();
  if (state.pin_velocity.isZero(0.0)) return;
  step_.now().pin_velocity = state.pin_velocity;
  Resolve();
}

IslandEvents ExactSolver::TakeEvents() {
  IslandEvents events = log_.Take();
  events.breaks = dynamics_->mode().constraints.TakeBreaks();
  return events;
}

void ExactSolver::Restart() { step_end_ ? StepInTime() : Resolve(); }

// Which limits hold which hinges from now on, after the impact of those that go out and of a pin
// that was stopped; what they hold is no part of the state. Where that overloads a constraint it
// breaks.
void ExactSolver::Resolve() {
  next_ = Next::kGoOn;
  follows_event_ = true;
  step_end_.reset();
  dynamics_->mode().constant.Clear();
  if (switch_.EntersAtTouch(time(), step_.now())) return StepInTime();
  do {
    held_.Resolve(time(), release_search_.later(), &step_.now(), &log_);
    release_search_.Begin();
    dynamics_->mode().layout.SetLocked(held_.held(), now().q);
    step_.Begin();
  } while (BreakOverloaded());
  log_.Mark(time(), held_.StateSum());
}

bool ExactSolver::BreakOverloaded() {
  ConstraintSet& constraints = dynamics_->mode().constraints;
  if (!constraints.may_break()) return false;
  const RowSystem& rows = dynamics_->rows();
  const auto worst = constraints.WorstOverload(rows.rows(), rows.forces(), /*are_impulses=*/false);
  if (worst.excess > 0.0) constraints.Break(worst.constraint, time());
  return worst.excess > 0.0;
}

// Ends the step where a constraint is overloaded first, as far as it shows at its quarters.
bool ExactSolver::FindBreak() {
  constexpr int kLooks = 4;
  const double start = step_.start_time(), length = time() - start;
  const auto overload = [&](double t) { return step_.WorstOverload(t).excess; };
  double before = start, f_before = overload(start);
  for (int look = 1; look <= kLooks; ++look) {
    const double t = look == kLooks ? time() : start + length * look / kLooks;
    const double f = overload(t);
    if (f > 0.0) {
      const Bracket at = Narrow({before, std::min(f_before, 0.0), t, f}, kSameTime, overload);
      breaks_next_ = step_.WorstOverload(at.b).constraint;
      step_.EndAt(at.b);
      return true;
    }
    before = t;
    f_before = f;
  }
  return false;
}

// Near a singular pose forces of constraints depend on rounding, and no step succeeds.
std::optional<ExactFailure> ExactSolver::Advance(double end) {
  std::optional<ExactFailure> failure = TryToAdvance(end);
  if (!failure || failure->cause == ExactFailure::Cause::kEndsApart) return failure;
  const std::optional<int> singular = step_.SingularConstraint();
  if (!singular) return failure;
  return ExactFailure{failure->hinge, ExactFailure::Cause::kNoHold, 0.0, *singular};
}

std::optional<ExactFailure> ExactSolver::TryToAdvance(double end) {
  HAZUMI_ASSERT(end >= time());
  if (dynamics_->work().total() > kMostWork + kMostWorkPerSecond * (time() - first_start_)) {
    return ExactFailure{step_.worst_hinge(), ExactFailure::Cause::kTooMuchWork};
  }
  if (next_ == Next::kEvent) MakeEventHappen();
  if (next_ == Next::kGoOnFromCut) {
    dynamics_->mode().layout.SetLocked(held_.held(),
                                       now().q);  // a ball joint may be on the other side of a pole
    step_.GoOn();
  }
  next_ = Next::kGoOn;
  if (step_end_) return AdvanceInTime(end);
  if (switch_.EntersBeforeStep(time(), steps_)) {
    StepInTime();
    return AdvanceInTime(end);
  }
  if (const std::optional<ExactFailure> failure = TakeToFirstContactChange(SmoothUntil(end))) {
    // Sliding contacts may jam, which needs an impulse since no finite forces prevent it, and
    // springs may be too stiff for any step.
    if (!switch_.EntersAfterFailure()) return failure;
    StepInTime();
    return AdvanceInTime(end);
  }
  ++steps_;
  const bool is_cut = time() > end;
  const bool contacts_go_on = has_contacts() && !contact_search_.has_found();
  if (contacts_go_on && !is_cut && contact_search_.FollowToEnd()) next_ = Next::kEvent;
  if (held_.any() && release_search_.Find()) next_ = Next::kEvent;
  if (dynamics_->mode().constraints.may_break() && FindBreak()) next_ = Next::kEvent;
  CutAt(end);
  // Contacts and limits of a cut step go on from what they are at the cut.
  if (is_cut && next_ == Next::kGoOnFromCut) {
    if (contacts_go_on && contact_search_.FollowToEnd()) next_ = Next::kEvent;
    if (held_.any()) release_search_.Cut();
  }
  follows_event_ = false;
  range_.Tighten(now().q);
  return std::nullopt;
}

// One step, with the hits of limits and the first change of a contact. A step whose stages do not
// show how friction turns is repeated:
// - If sliding stops early in the step: up to a little beyond the stop. Stages beyond the stop keep
//   the direction of friction (ContactSet::SlideOf).
// - If the defect is large: at half the length. Friction turned between the stages, or a limb that
//   constraints hold became straight.
std::optional<ExactFailure> ExactSolver::TakeToFirstContactChange(double end) {
  constexpr int kMostTries = 20;
  constexpr double kEarly = 0.5, kBeyond = 1.5;  // of the step; of its part before the stop
  const bool repeats = dynamics_->mode().contacts.rules().slides_straight_beyond_stop;
  double until = end;
  for (int tries = 0;; ++tries) {
    next_ = Next::kGoOn;
    if (const std::optional<ExactFailure> failure = Take(until)) return failure;
    const double whole = time() - step_start();
    if (range_.any()) FindHits();
    if (!has_contacts()) return std::nullopt;
    const bool found = contact_search_.Find(follows_event_);
    if (found) next_ = Next::kEvent;
    if (!repeats || tries == kMostTries) return std::nullopt;
    const double part = time() - step_start();
    if (found && contact_search_.found_stop() && part < kEarly * whole) {
      until = step_start() + kBeyond * part;
    } else if (HasLargeDefect()) {
      until = step_start() + 0.5 * part;
    } else {
      return std::nullopt;
    }
    step_.TakeBack();
  }
}

// The error estimate of a step uses the same stages as the step, and misses what lies between them.
bool ExactSolver::HasLargeDefect() {
  constexpr double kMostDefect = 30.0;  // tolerances
  constexpr double kRounding = 1e-13;   // least tolerance for which the defect is not rounding
  const bool is_pushed = dynamics_->mode().any_rows();
  return is_pushed && step_.tolerance() > kRounding && step_.Defect() > kMostDefect;
}

// Cuts a step at `end`. Discards the part beyond it, with its events.
void ExactSolver::CutAt(double end) {
  const bool is_there = time() > end || (next_ == Next::kGoOn && time() > end - kSameTime);
  if (time() == end || !is_there) return;
  step_.EndAt(end);
  next_ = Next::kGoOnFromCut;
  breaks_next_ = -1;
}

// One step, which a kink ends: beyond one it would be of no order. In time-stepping mode its end is
// near.
std::optional<ExactFailure> ExactSolver::Take(double end) {
  const bool is_near = step_end_.has_value();
  const std::optional<ExactFailure> failure = step_.Take(end, is_near);
  if (failure || !dynamics_->has_kinks()) return failure;
  const std::optional<double> kink = kink_search_.Find();
  if (!kink) return std::nullopt;
  step_.TakeBack();
  return step_.Take(*kink, is_near);
}

void ExactSolver::FindHits() {
  const HitSearch::Found found = hit_search_.Find(held_.held(), follows_event_);
  if (found == HitSearch::Found::kHit) next_ = Next::kEvent;
  if (found == HitSearch::Found::kPole) next_ = Next::kGoOnFromCut;
}

// A limit was hit or lets go, a contact changes, or a constraint breaks.
void ExactSolver::MakeEventHappen() {
  if (breaks_next_ >= 0) dynamics_->mode().constraints.Break(breaks_next_, time());
  breaks_next_ = -1;
  range_.Widen(now().q);
  if (step_end_) return switch_.Leaves() ? FollowEvents() : StepInTime();
  held_.CountEvent(time());
  switch_.EntersAfterEvent(time()) ? StepInTime() : Resolve();
}

// Enters time-stepping mode, or takes its next step. Where what is found overloads a constraint it
// breaks.
void ExactSolver::StepInTime() {
  step_.now().pin_velocity.setZero();  // contacts carry the figure, not the pin
  if (!step_end_) {
    time_stepping_.Enter(time());
    held_.LetGo();
    if (!time_stepping_from_) time_stepping_from_ = time();
  }
  do {
    time_stepping_.Set(time(), &step_.now(), &log_);
    dynamics_->mode().layout.SetLocked(held_.held(), now().q);
    step_.Begin();
  } while (BreakOverloaded());
  release_search_.Begin();
  step_end_ = time() + time_stepping_.length();
  follows_event_ = true;
}

// Leaves time-stepping mode.
void ExactSolver::FollowEvents() {
  time_stepping_.Leave(time());
  switch_.BeginEvents(time(), steps_);
  held_.ForgetEvents();
  Resolve();
}

std::optional<ExactFailure> ExactSolver::AdvanceInTime(double end) {
  bool has_blow = false;
  for (;;) {
    const double until = std::min(SmoothUntil(end), *step_end_);
    if (const std::optional<ExactFailure> failure = Take(until)) return failure;
    const RegionState now = step_.PlaceNow();
    if (!time_stepping_.GivesTooMuch(time() - step_start(), now)) {
      has_blow = contact_search_.FindBlow(now);
      break;
    }
    step_.TakeBack();
    if (time_stepping_.Halve()) {
      StepInTime();
      continue;
    }
    time_stepping_.GiveNothing();
    step_.Begin();
  }
  ++steps_;
  if (has_blow || time() >= *step_end_ - kSameTime) next_ = Next::kEvent;
  if (dynamics_->mode().constraints.may_break() && FindBreak()) next_ = Next::kEvent;
  CutAt(end);
  if (dynamics_->mode().contacts.rules().limits_follow_hinges) range_.Tighten(now().q);
  return std::nullopt;
}

}  // namespace hazumi
