#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/bake/group_answers.h"
#include "engine/bake/rotation_state.h"

namespace hazumi {

// The motion of one group, as it answers for it (GroupAnswers).
class GroupSolution {
 public:
  // `moving_bases` must outlive it.
  GroupSolution(GroupTask task, MovingBaseCache* moving_bases);

  const RegionModel& model() const { return task_->model; }
  const RegionLayout& layout() const { return layout_; }
  const std::vector<FreeHinge>& hinges() const { return layout_.hinges(); }
  double step_tolerance() const { return task_->step_tolerance; }

  // Begins at t, with curves that are smooth up to `end`. `known`: logs of earlier bakes; null: it
  // keeps none itself.
  void Begin(double t, double end, const RotationState& state, const DrivenMotion& driven,
             const KnownLogs* known);
  // Goes on from t, where it is, with other curves.
  void Drive(double t, double end, const DrivenMotion& driven);
  // A pin that moved with v_pin [m/s] was stopped at the time where it began.
  void FeelPin(const Vec3& v_pin);
  // Takes steps until it is beyond t, at most to `end`.
  void Advance(double t, double end);

  // Goes on to `end` at once; afterwards it can be sampled at `times`, which rise and include
  // `end`, and nowhere else. True if a known log tells how: else SolveAhead is to be called, which
  // may be done in any thread while no one asks this solution anything. It gives up where `cancel`
  // is set.
  bool LookAhead(const std::vector<double>& times, double end);
  void SolveAhead(const std::atomic<bool>* cancel);

  // How far it has got [s], and why it cannot go on from there.
  double time() const { return time_; }
  const std::optional<ExactFailure>& failure() const { return failure_; }
  // Start of the step inside which it can be sampled [s].
  double step_start() const { return step_start_; }

  // Free hinges at t, their entries of `state`.
  void Sample(double t, RotationState* state);
  // By free hinge: how far two states are apart [rad].
  VecX Distances(const RotationState& a, const RotationState& b) const;
  EnergyFlow Energy(double t);
  // Hits since the last call.
  std::vector<StopHit> TakeHits() { return std::exchange(hits_, {}); }

  long evaluations() const { return answers_.evaluations(); }
  long steps() const { return answers_.steps(); }
  // It took to solve [us], whenever that was.
  double microseconds() const { return microseconds_; }
  std::shared_ptr<const GroupLog> log() const { return answers_.log(); }

 private:
  void TakeProgress(const GroupProgress& progress);
  void TakeAhead(const GroupResult& result);
  void Scatter(const double* sample, RotationState* state) const;

  std::shared_ptr<const GroupTask> task_;
  RegionLayout layout_;  // nothing locked
  GroupAnswers answers_;
  double time_ = 0.0, step_start_ = 0.0;
  std::optional<ExactFailure> failure_;
  std::vector<StopHit> hits_;
  // What SolveAhead is to solve; the times that were looked ahead to, and what is there.
  SolveGroup ahead_;
  std::vector<double> times_;
  GroupSamples samples_;
  double microseconds_ = 0.0;
};

}  // namespace hazumi
