#include "engine/passive/exact/exact_solver.h"

#include <utility>

namespace hazumi {

namespace {

// From the first start on, so that what cannot be solved ends within ten seconds.
constexpr double kMostWork = 1e6, kMostWorkPerSecond = 1e6;  // in evaluations

}  // namespace

ExactSolver::ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper)
    : dynamics_(dynamics),
      range_(std::move(lower), std::move(upper)),
      step_(dynamics, &range_),
      held_(dynamics, &range_),
      hit_search_(dynamics, &range_, &step_),
      release_search_(&step_, &held_),
      hits_(dynamics->num_hinges()) {}

void ExactSolver::Start(double t, const VecX& q, const VecX& qd, const PointMotion& anchor) {
  if (steps_ == 0) first_start_ = t;
  step_.Place(t, q, qd, anchor);
  range_.Begin(q);
  held_.Begin();
  release_search_.Begin();
  Resolve(Vec3::Zero());
}

void ExactSolver::Restart() { Resolve(Vec3::Zero()); }

void ExactSolver::FeelPin(const Vec3& v_pin) { Resolve(v_pin); }

// Which limits hold which hinges from now on, after the impact of those that go out and of a pin
// that was stopped; what they hold is no part of the state.
void ExactSolver::Resolve(const Vec3& v_pin) {
  next_ = Next::kGoOn;
  follows_event_ = true;
  dynamics_->SetAnchor(step_.anchor());
  held_.Resolve(time(), v_pin, release_search_.later(), &step_.now(), &hits_);
  release_search_.Begin();
  dynamics_->SetLocked(held_.held(), q());
  step_.Begin();
}

std::optional<ExactFailure> ExactSolver::Advance(double end) {
  if (dynamics_->work() > kMostWork + kMostWorkPerSecond * (time() - first_start_)) {
    return ExactFailure{step_.worst_hinge(), ExactFailure::Cause::kTooManyEvaluations};
  }
  if (next_ == Next::kEvent) MakeEventHappen();
  if (next_ == Next::kGoOnFromCut) step_.GoOn();
  next_ = Next::kGoOn;
  if (const std::optional<ExactFailure> failure = step_.Take(end)) return failure;
  ++steps_;
  if (!range_.any()) return std::nullopt;
  const HitSearch::Found found = hit_search_.Find(held_.held(), follows_event_);
  if (found == HitSearch::Found::kHit) next_ = Next::kEvent;
  if (found == HitSearch::Found::kPole) next_ = Next::kGoOnFromCut;
  if (held_.any() && release_search_.Find()) next_ = Next::kEvent;
  follows_event_ = false;
  range_.Tighten(q());
  return std::nullopt;
}

// A limit was hit or lets go.
void ExactSolver::MakeEventHappen() {
  held_.CountEvent(time());
  range_.Widen(q());
  Resolve(Vec3::Zero());
}

}  // namespace hazumi
