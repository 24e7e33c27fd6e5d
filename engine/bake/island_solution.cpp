#include "engine/bake/island_solution.h"

#include <algorithm>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/spatial/checks.h"

namespace hazumi {

SharedIsland::SharedIsland(IslandTask island_task) : task(std::move(island_task)) {
  hinges.reserve(static_cast<size_t>(task.model.num_free));
  bool any_ball = false;
  for (const ModelNode& node : task.model.nodes) {
    if (node.role != Role::kFree) continue;
    for (int h = 0; h < node.num_hinges; ++h) hinges.push_back(node.hinges[h].coordinate);
    any_ball |= node.is_ball;
  }
  if (any_ball) with_balls.emplace(task.model, /*balls=*/true);
}

IslandSolution::IslandSolution(std::shared_ptr<const SharedIsland> island,
                               const Tolerance& tolerance, MovingBaseCache* moving_bases)
    : island_(std::move(island)),
      tolerance_(tolerance),
      answers_({island_, &island_->task}, moving_bases) {}

void IslandSolution::Begin(double t, double end, const RotationState& state,
                           std::shared_ptr<const DrivenMotion> curves, const KnownLogs* known) {
  HAZUMI_ASSERT(t <= end);
  HAZUMI_ASSERT(curves != nullptr);
  const auto k = static_cast<Eigen::Index>(hinges().size());
  const IslandTask& task = island_->task;
  HingeState own{VecX(k), VecX(k)};
  if (task.is_placed()) own.outer.anchor = state.anchor;
  if (!model().balls.empty()) {
    for (const LooseObject& loose : state.loose) own.outer.balls.push_back(loose.motion);
  }
  for (Eigen::Index i = 0; i < k; ++i) {
    own.q[i] = state.q[hinges()[i]];
    own.qd[i] = state.qd[hinges()[i]];
  }
  own.pin_velocity = state.pin_velocity;
  answers_.Begin(
      {t, end, tolerance_.step, tolerance_.of_solution, std::move(own), curves, {island_, &task}},
      known);
  time_ = step_start_ = t;
}

void IslandSolution::Drive(double t, double end, std::shared_ptr<const DrivenMotion> curves) {
  times_.reset();
  answers_.Tell(DriveIsland{t, end, std::move(curves)});
}

void IslandSolution::Advance(double t, double end) {
  if (time_ > t || time_ >= end) return;
  times_.reset();
  TakeProgress(answers_.Ask(AdvanceIsland{t, end}));
}

bool IslandSolution::LookAhead(std::shared_ptr<const std::vector<double>> times, double end) {
  times_ = std::move(times);
  ahead_end_ = end;
  SolveIsland request = {end, times_};
  if (!answers_.IsKnown(request)) return false;
  TakeAhead(answers_.Ask(std::move(request)));
  return true;
}

void IslandSolution::SolveAhead(const std::atomic<bool>* cancel) {
  answers_.SetCancel(cancel);
  TakeAhead(answers_.Ask(SolveIsland{ahead_end_, times_}));
}

void IslandSolution::TakeProgress(const IslandProgress& progress) {
  time_ = progress.time;
  step_start_ = progress.step_start;
  microseconds_ += progress.microseconds;
  events_.Append(progress.events);
  for (const EventMark& mark : std::exchange(events_.marks, {})) trail_.Add(mark);
  time_stepping_from_ = progress.time_stepping_from;
  if (progress.failure) failure_ = progress.failure;
}

IslandEvents IslandSolution::TakeEvents() {
  IslandEvents events = std::exchange(events_, {});
  events_.impacts = std::exchange(events.impacts, {});
  return events;
}

void IslandSolution::TakeAhead(const IslandCourse& course) {
  TakeProgress(course.progress);
  samples_ = course.samples;
}

void IslandSolution::Sample(double t, RotationState* state, Gaps gaps) {
  if (const auto ahead = AheadAt(t)) return Scatter(samples_, *ahead, state);
  Scatter(answers_.Ask(SampleIsland{t, gaps}), 0, state);
}

// Which of the samples is of this time, if it was looked ahead to.
std::optional<size_t> IslandSolution::AheadAt(double t) const {
  if (!times_) return std::nullopt;
  const auto ahead = std::lower_bound(times_->begin(), times_->end(), t);
  const auto index = static_cast<size_t>(ahead - times_->begin());
  const bool is_there = ahead != times_->end() && *ahead == t &&
                        2 * hinges().size() * (index + 1) <= samples_.hinges.size();
  return is_there ? std::optional(index) : std::nullopt;
}

void IslandSolution::Scatter(const IslandSamples& samples, size_t index,
                             RotationState* state) const {
  HAZUMI_ASSERT(2 * hinges().size() * (index + 1) <= samples.hinges.size());
  const int k = static_cast<int>(hinges().size());
  const double* sample = samples.hinges.data() + 2 * hinges().size() * index;
  for (int i = 0; i < k; ++i) {
    state->q[hinges()[i]] = sample[i];
    state->qd[hinges()[i]] = sample[k + i];
  }
  if (samples.outer.empty()) return;
  const OuterMotion& outer = samples.outer[index];
  if (solves_fall()) state->anchor = outer.anchor;
  const std::vector<LooseBall>& balls = model().balls;
  if (balls.empty()) return;
  state->loose.resize(balls.size());
  for (size_t i = 0; i < balls.size(); ++i) state->loose[i] = {balls[i].object, outer.balls[i]};
}

VecX IslandSolution::Distances(const RotationState& a, const RotationState& b) const {
  HAZUMI_ASSERT(a.q.size() == b.q.size());
  const int k = static_cast<int>(hinges().size());
  VecX q(k), other(k), distances(k);
  for (int i = 0; i < k; ++i) {
    q[i] = a.q[hinges()[i]];
    other[i] = b.q[hinges()[i]];
  }
  if (!island_->with_balls) return (q - other).cwiseAbs();
  island_->with_balls->Distances(q, other, &distances);
  return distances;
}

Vec3 IslandSolution::Accelerations(double t, VecX* rates, VecX* accelerations) {
  const InstantReport& instant = answers_.Ask(AccelerateIsland{t});
  for (size_t i = 0; i < hinges().size(); ++i) {
    (*rates)[hinges()[i]] = instant.qd[static_cast<Eigen::Index>(i)];
    (*accelerations)[hinges()[i]] = instant.qdd[static_cast<Eigen::Index>(i)];
  }
  return instant.fall;
}

EnergyFlow IslandSolution::Energy(double t) { return answers_.Ask(MeasureIsland{t}); }

}  // namespace hazumi
