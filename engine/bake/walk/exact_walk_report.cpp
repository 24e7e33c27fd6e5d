// Writes down what a walk's driver did: limits and contacts that were hit, constraints that broke
// or did not arrive, and the reports of its regions.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/bake/walk/exact_walk.h"

namespace hazumi {

// Records what happened, hits of limits up to a time [s].
void ExactWalk::AddEvents(double until) {
  const ExactDriver::Events events = driver_->TakeEvents();
  for (const ExactDriver::Hit& hit : events.hits) {
    if (hit.time > until) continue;
    context_.recorder.AddLimit(JointIndex(hit.coordinate), hit.time, hit.last_time, hit.count);
  }
  for (const TouchDown& touch : events.touches) context_.recorder.AddTouch(touch);
  for (const ConstraintBreak& broken : events.breaks) AddBreak(broken);
}

void ExactWalk::AddBreak(const ConstraintBreak& broken) {
  const Constraint& constraint = context_.animation.constraints[broken.constraint];
  context_.now.broken.push_back(broken.constraint);
  // Islands list their contacts where they begin; what the constraint parted collides from now on.
  if (context_.animation.solver.rules().parts_what_is_tied && constraint.parts()) Interrupt();
  const double frame = context_.animation.rate.FrameAt(broken.time);
  context_.recorder.AddEvent(EventKind::kBreak, frame, constraint.name);
  for (Warning& warning : arrivals_.Break(broken.constraint, frame)) {
    context_.recorder.AddWarning(std::move(warning));
  }
}

void ExactWalk::LookAtArrivals(const FigureMotion& motion) {
  if (!driver_ || context_.animation.constraints.empty()) return;
  DynamicsWorkspace* const ws = &context_.poses.workspace();
  std::optional<Arrivals::IsFree> is_free;
  if (context_.poses.placement().hold().coupling == RootCoupling::kPrescribed) {
    is_free = [this](JointIndex j) { return moves(j); };
  }
  for (Warning& warning : arrivals_.Look(driver_->constraints(), motion, is_free, ws)) {
    context_.recorder.AddWarning(std::move(warning));
  }
}

void ExactWalk::WriteReports() {
  const std::vector<int>& active = driver_->regions().indices();
  driver_->MoveLogsTo(&context_.recorder.logs());
  for (size_t a = 0; a < active.size(); ++a) {
    RegionReport& report = context_.recorder.report(active[a]);
    report.steps += static_cast<int>(driver_->steps());
    report.evaluations += static_cast<int>(driver_->evaluations());
    report.microseconds += driver_->microseconds() / static_cast<double>(active.size());
    report.islands = driver_->island_sizes();
    report.bodies = driver_->num_bodies();
    report.energy = driver_->energy();
    const RegionEstimates::Estimate estimate = driver_->estimates().Of(a);
    report.error_estimate = std::max(report.error_estimate, estimate.error);
    if (!report.estimated_until && std::isfinite(estimate.until)) {
      report.estimated_until = context_.animation.rate.FrameAt(estimate.until);
    }
    if (!report.branches_from && std::isfinite(estimate.branches_from)) {
      report.branches_from = context_.animation.rate.FrameAt(estimate.branches_from);
    }
  }
}

}  // namespace hazumi
