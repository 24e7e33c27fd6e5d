#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/bake/island_answers.h"
#include "engine/bake/rotation_state.h"

namespace hazumi {

// What all solutions of an island share.
struct SharedIsland {
  explicit SharedIsland(IslandTask island_task);

  IslandTask task;
  std::vector<Coordinate> hinges;          // free ones
  std::optional<RegionLayout> with_balls;  // where there are any; nothing locked
};

// The motion of one island, as it answers for it (IslandAnswers).
class IslandSolution {
 public:
  // Error of one step, and, of a control solution, that of a step of the solution which it is
  // compared with; else 0 (ExactStep::SetTolerance) [rad].
  struct Tolerance {
    double step, of_solution = 0.0;
  };
  // `moving_bases` must outlive it.
  IslandSolution(std::shared_ptr<const SharedIsland> island, const Tolerance& tolerance,
                 MovingBaseCache* moving_bases);

  // Whether the fall of the centre of mass is solved along, and sampled as the state's anchor.
  bool solves_fall() const {
    return model().coupling == RootCoupling::kFlight && island_->task.is_placed();
  }
  const RegionModel& model() const { return island_->task.model; }
  const std::vector<Coordinate>& hinges() const { return island_->hinges; }
  double step_tolerance() const { return tolerance_.step; }

  // Begins at t, with curves (CurvesOf) that are smooth up to `end`. `known`: logs of earlier
  // bakes; null: it keeps none itself.
  void Begin(double t, double end, const RotationState& state,
             std::shared_ptr<const DrivenMotion> curves, const KnownLogs* known);
  // Goes on from t, where it is, with other curves.
  void Drive(double t, double end, std::shared_ptr<const DrivenMotion> curves);
  // Takes steps until it is beyond t, at most to `end`.
  void Advance(double t, double end);

  // Goes on to `end` at once; afterwards it can be sampled at `times`, which rise and include
  // `end`, and nowhere else. True if a known log tells how: else SolveAhead is to be called, which
  // may be done in any thread while no one asks this solution anything. It gives up where `cancel`
  // is set.
  bool LookAhead(std::shared_ptr<const std::vector<double>> times, double end);
  void SolveAhead(const std::atomic<bool>* cancel);

  // How far it has got [s], and why it cannot go on from there.
  double time() const { return time_; }
  const std::optional<ExactFailure>& failure() const { return failure_; }
  // As ExactSolver [s].
  const std::optional<double>& time_stepping_from() const { return time_stepping_from_; }
  // Start of the step inside which it can be sampled [s].
  double step_start() const { return step_start_; }

  // Free hinges at t, their entries of `state`.
  void Sample(double t, RotationState* state, Gaps gaps = Gaps::kClosed);
  // By free hinge: how far two states are apart [rad].
  VecX Distances(const RotationState& a, const RotationState& b) const;
  EnergyFlow Energy(double t);
  // And rates, by Coordinate, of its free hinges alone; returns that of the centre of mass, as
  // ExactStep.
  Vec3 Accelerations(double t, VecX* rates, VecX* accelerations);
  // What its constraints do there, by index of the task's.
  std::vector<ConstraintPush> ConstraintPushes(double t) {
    return answers_.Ask(AccelerateIsland{t}).constraints;
  }
  // What pushes it where it touches the scene; none if it never does.
  std::vector<ContactPush> ContactPushes(double t) {
    if (island_->task.contacts.empty()) return {};
    return answers_.Ask(AccelerateIsland{t}).contacts;
  }
  std::vector<SpentDrive> SpentDrives(double t) { return answers_.Ask(AccelerateIsland{t}).spent; }
  // Returns the events since the last call, without marks and the work of impacts.
  IslandEvents TakeEvents();
  // Returns the work of impacts since the last call.
  ImpactWork TakeImpactWork() { return std::exchange(events_.impacts, {}); }
  // All events since the beginning.
  const EventTrail& trail() const { return trail_; }

  long evaluations() const { return answers_.evaluations(); }
  long steps() const { return answers_.steps(); }
  const Work& work() const { return answers_.work(); }
  // It took to solve [us], whenever that was.
  double microseconds() const { return microseconds_; }
  std::shared_ptr<const IslandLog> log() const { return answers_.log(); }

 private:
  void TakeProgress(const IslandProgress& progress);
  void TakeAhead(const IslandCourse& course);
  std::optional<size_t> AheadAt(double t) const;
  void Scatter(const IslandSamples& samples, size_t index, RotationState* state) const;

  std::shared_ptr<const SharedIsland> island_;
  Tolerance tolerance_;
  IslandAnswers answers_;
  double time_ = 0.0, step_start_ = 0.0;
  std::optional<ExactFailure> failure_;
  std::optional<double> time_stepping_from_;
  IslandEvents events_;  // not taken yet
  EventTrail trail_;
  // What was looked ahead to, null if nothing was, and the samples there.
  double ahead_end_ = 0.0;
  std::shared_ptr<const std::vector<double>> times_;
  IslandSamples samples_;
  double microseconds_ = 0.0;
};

}  // namespace hazumi
