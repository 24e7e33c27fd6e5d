#include "engine/bake/island_run.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

using Clock = std::chrono::steady_clock;

double MicrosecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

}  // namespace

double LongestStep(const RegionDynamics& dynamics) {
  // Laws slow motion down by e to the power of this in a step at most: beyond it the estimate of a
  // step's error is no estimate.
  constexpr double kMostDecay = 2.0;
  const double rate = dynamics.FastestRate();
  return rate > 0.0 ? kMostDecay / rate : std::numeric_limits<double>::infinity();
}

IslandRun::IslandRun(const IslandTask& task, MovingBaseCache* moving_bases)
    : gravity_(task.gravity),
      moving_bases_(moving_bases),
      dynamics_(WithOwnCurves(task.model), MakeLaws(task.forces), task.gravity, task.constraints,
                task.contacts),
      solver_(&dynamics_, task.lower, task.upper),
      longest_step_(LongestStep(dynamics_)) {}

IslandResult IslandRun::Do(const IslandRequest& request, const std::atomic<bool>* cancel) {
  cancel_ = cancel;
  return std::visit([this](const auto& of_a_kind) -> IslandResult { return Do(of_a_kind); },
                    request);
}

BeginIsland::Result IslandRun::Do(const BeginIsland& request) {
  HAZUMI_ASSERT(request.step_tolerance > 0.0);
  HAZUMI_ASSERT(IsFinite(request.state.q) && IsFinite(request.state.qd));
  Attach(request.curves, request.t, request.end);
  solver_.SetTolerance(request.step_tolerance, request.solution_tolerance);
  solver_.Start(request.t, request.state);
  return {};
}

DriveIsland::Result IslandRun::Do(const DriveIsland& request) {
  Attach(request.curves, request.t, request.end);
  solver_.Restart();
  return {};
}

void IslandRun::Attach(const std::shared_ptr<const DrivenMotion>& curves, double t, double end) {
  HAZUMI_ASSERT(curves != nullptr && t <= end);
  curves_ = curves;
  RegionKinematics& kinematics = dynamics_.kinematics();
  kinematics.SetCurves(curves_.get(), t, dynamics_.layout());
  const bool is_fitted = kinematics.needs_moving_base();
  solver_.SetLongestStep(is_fitted && curves_->may_be_cut()
                             ? std::min(longest_step_, DrivenMotion::kLongestCut)
                             : longest_step_);
  if (!is_fitted) return;
  Carrier carrier =
      CarrierOf(dynamics_.model(), kinematics.first_moved(), gravity_, *curves_, t, end);
  kinematics.UseMovingBase(moving_bases_->Get(
      std::move(carrier), [&] { return kinematics.FitMovingBase(t, end, dynamics_.layout()); }));
}

AdvanceIsland::Result IslandRun::Do(const AdvanceIsland& request) {
  const Clock::time_point start = Clock::now();
  std::optional<ExactFailure> failure;
  while (!failure && solver_.time() <= request.t && solver_.time() < request.end) {
    failure = solver_.Advance(request.end);
  }
  IslandProgress progress = Progress(failure);
  progress.microseconds = MicrosecondsSince(start);
  return progress;
}

// What is at a time is that of the step which ends there, if one does.
SolveIsland::Result IslandRun::Do(const SolveIsland& request) {
  const Clock::time_point start = Clock::now();
  std::optional<ExactFailure> failure;
  IslandCourse course;
  course.samples.hinges.reserve(request.times->size() * 2 *
                                static_cast<size_t>(dynamics_.num_hinges()));
  for (const double t : *request.times) {
    while (!failure && solver_.time() < std::min(t, request.end) && !is_cancelled()) {
      failure = solver_.Advance(request.end);
    }
    if (failure || is_cancelled()) break;
    Sample(t, Gaps::kClosed, &course.samples);
  }
  course.progress = Progress(failure);
  course.progress.microseconds = MicrosecondsSince(start);
  return course;
}

SampleIsland::Result IslandRun::Do(const SampleIsland& request) {
  IslandSamples samples;
  Sample(request.t, request.gaps, &samples);
  return samples;
}

MeasureIsland::Result IslandRun::Do(const MeasureIsland& request) {
  return solver_.Energy(request.t);
}

AccelerateIsland::Result IslandRun::Do(const AccelerateIsland& request) {
  return solver_.Report(request.t);
}

IslandProgress IslandRun::Progress(const std::optional<ExactFailure>& failure) {
  return {solver_.time(),      solver_.step_start(), failure, 0.0, solver_.time_stepping_from(),
          solver_.TakeEvents()};
}

void IslandRun::Sample(double t, Gaps gaps, IslandSamples* samples) {
  solver_.Sample(t, &sample_, gaps);
  samples->hinges.insert(samples->hinges.end(), sample_.q.begin(), sample_.q.end());
  samples->hinges.insert(samples->hinges.end(), sample_.qd.begin(), sample_.qd.end());
  if (dynamics_.outer_layout().size() > 0) samples->outer.push_back(sample_.outer);
}

}  // namespace hazumi
