#pragma once

#include <atomic>

#include "engine/bake/group_request.h"
#include "engine/bake/moving_base_cache.h"
#include "engine/passive/exact/exact_solver.h"

namespace hazumi {

// A group at work: it does one request after the other, the same ones always in the same way.
class GroupRun {
 public:
  // `moving_bases` must outlive it.
  GroupRun(const GroupTask& task, MovingBaseCache* moving_bases);

  // Gives up where `cancel` is set; the result is of no use then.
  GroupResult Do(const GroupRequest& request, const std::atomic<bool>* cancel);

  // So far.
  long evaluations() const { return dynamics_.evaluations(); }
  long steps() const { return solver_.steps(); }

 private:
  GroupResult Do(const BeginGroup& request);
  GroupResult Do(const DriveGroup& request);
  GroupResult Do(const StopPin& request);
  GroupResult Do(const AdvanceGroup& request);
  GroupResult Do(const SolveGroup& request);
  GroupResult Do(const SampleGroup& request);
  GroupResult Do(const MeasureGroup& request);

  // The model is moved by these curves, which are smooth from t to `end`.
  void Attach(const std::shared_ptr<const DrivenMotion>& curves, double t, double end);
  bool is_cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }
  GroupProgress Progress(const std::optional<ExactFailure>& failure);
  void Sample(double t, GroupSamples* samples);

  double gravity_;
  MovingBaseCache* moving_bases_;
  const std::atomic<bool>* cancel_ = nullptr;
  std::shared_ptr<const DrivenMotion> curves_;
  RegionDynamics dynamics_;
  ExactSolver solver_;
  VecX q_, qd_;
};

}  // namespace hazumi
