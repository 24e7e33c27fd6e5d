#pragma once

#include <atomic>

#include "engine/bake/island_request.h"
#include "engine/bake/moving_base_cache.h"
#include "engine/region/exact/exact_solver.h"

namespace hazumi {

// Returns the longest step with which an island is solved [s]; infinity: any.
double LongestStep(const RegionDynamics& dynamics);

// An island at work: it does one request after the other, the same ones always in the same way.
class IslandRun {
 public:
  // `moving_bases` must outlive it.
  IslandRun(const IslandTask& task, MovingBaseCache* moving_bases);

  // Gives up where `cancel` is set; the result is of no use then.
  IslandResult Do(const IslandRequest& request, const std::atomic<bool>* cancel);

  // So far.
  long evaluations() const { return dynamics_.evaluations(); }
  long steps() const { return solver_.steps(); }
  Work work() const { return dynamics_.model().num_bodies * dynamics_.work(); }

 private:
  BeginIsland::Result Do(const BeginIsland& request);
  DriveIsland::Result Do(const DriveIsland& request);
  AdvanceIsland::Result Do(const AdvanceIsland& request);
  SolveIsland::Result Do(const SolveIsland& request);
  SampleIsland::Result Do(const SampleIsland& request);
  MeasureIsland::Result Do(const MeasureIsland& request);
  AccelerateIsland::Result Do(const AccelerateIsland& request);

  // The model is moved by these curves, which are smooth from t to `end`.
  void Attach(const std::shared_ptr<const DrivenMotion>& curves, double t, double end);
  bool is_cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }
  IslandProgress Progress(const std::optional<ExactFailure>& failure);
  void Sample(double t, Gaps gaps, IslandSamples* samples);

  double gravity_;
  MovingBaseCache* moving_bases_;
  const std::atomic<bool>* cancel_ = nullptr;
  std::shared_ptr<const DrivenMotion> curves_;
  RegionDynamics dynamics_;
  ExactSolver solver_;
  // Largest step that the force laws allow [s].
  double longest_step_;
  HingeState sample_;
};

}  // namespace hazumi
