#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/passive/exact_solver.h"

namespace hazumi {

// All rotations of a figure, by Coordinate: N hinges, then the root's about z, y, x.
struct RotationState {
  VecX q, qd;  // [rad, rad/s]
};

// A group of joints that feel each other, and how accurately it is to be solved.
struct GroupTask {
  RegionModel model;
  VecX friction, lower, upper;  // by free hinge: rates [1/s], stops [rad]
  double gravity;               // along -z [m/s^2]
  double step_tolerance;        // of the main solution; its twin's is kTwinCoarseness times that
};

// What a solution was asked and what it answered, as numbers.
struct GroupCall {
  std::vector<double> question, answer;
  long evaluations = 0, steps = 0;  // up to the answer
};
// From the beginning on. The answers depend on nothing but the questions.
using GroupLog = std::vector<GroupCall>;
using GroupLogs = std::vector<std::shared_ptr<const GroupLog>>;

// The motion of one group, and beside it that of a twin with a coarser tolerance: how far they get
// apart tells how far the solution may be off.
//
// It keeps a log. As long as it is asked what a known log holds it answers from there and solves
// nothing; at the first other question it solves what was asked up to then.
class GroupSolution {
 public:
  static constexpr double kTwinCoarseness = 40.0;

  // `num_coordinates` of the figure: hinges and the root's three.
  GroupSolution(GroupTask task, int num_coordinates);

  const RegionModel& model() const { return task_.model; }
  const std::vector<FreeHinge>& hinges() const { return hinges_; }
  double step_tolerance() const { return task_.step_tolerance; }

  // Begins at t, with curves that are smooth up to `end`. `known`: logs of earlier bakes.
  void Begin(double t, double end, const RotationState& state, const RotationState& twin,
             const DrivenMotion& driven, const GroupLogs& known);
  // Goes on from t, where both solutions are, with other curves.
  void Drive(double t, double end, const DrivenMotion& driven);
  // A pin that moved with v_pin [m/s] was stopped at the time where it began.
  void FeelPin(const Vec3& v_pin);
  // Takes steps until both solutions are beyond t, at most to `end`.
  std::optional<ExactFailure> Advance(double t, double end);

  // How far the main solution and its twin have got [s].
  double time() const { return std::min(time_, twin_time_); }
  double main_time() const { return time_; }
  // Start of the main solution's step, inside which it can be sampled [s].
  double step_start() const { return step_start_; }

  // Free hinges at t, their entries of `state`; the twin's.
  void Sample(double t, RotationState* state);
  void SampleTwin(double t, RotationState* state);
  // By free hinge: how far the two are apart at t [rad].
  VecX Distances(double t);
  EnergyFlow Energy(double t);
  // Hits since the last call.
  std::vector<StopHit> TakeHits() { return std::exchange(hits_, {}); }

  long evaluations() const { return evaluations_; }
  long steps() const { return steps_; }
  // It took to solve [us], whenever that was.
  double microseconds() const { return microseconds_; }
  std::shared_ptr<const GroupLog> log() const { return own_ ? own_ : known_; }

 private:
  using Numbers = std::vector<double>;
  struct Run {
    RegionDynamics dynamics;
    ExactSolver solver;
    Run(const GroupTask& task, double step_tolerance);
  };
  // Both solutions at work.
  struct Pair {
    DrivenMotion driven;
    Run main, twin;
    Pair(const GroupTask& task, int num_coordinates);
    std::array<Run*, 2> runs() { return {&main, &twin}; }
  };

  const Numbers& Ask(Numbers question);
  void SolveWhatWasAsked();
  GroupCall Execute(Numbers question);
  void ExecuteBegin(const double* arguments);
  void ExecuteDrive(const double* arguments);
  Numbers ExecuteAdvance(double t, double end);
  static Numbers ExecuteSample(Run* run, double t);
  void AppendTask(Numbers* question) const;
  void AppendCurves(const DrivenMotion& driven, Numbers* question) const;
  void ReadCurves(const double* numbers);
  void Scatter(const Numbers& answer, RotationState* state) const;
  template <typename Action>
  void ForEachCurve(Action&& action) const;

  GroupTask task_;
  int num_coordinates_;
  std::vector<FreeHinge> hinges_;
  std::shared_ptr<const GroupLog> known_;  // answers as long as own_ is null
  std::shared_ptr<GroupLog> own_;
  size_t num_calls_ = 0;
  std::unique_ptr<Pair> pair_;  // null as long as own_ is
  double time_ = 0.0, twin_time_ = 0.0, step_start_ = 0.0;
  std::vector<StopHit> hits_;
  long evaluations_ = 0, steps_ = 0;
  double microseconds_ = 0.0;
};

}  // namespace hazumi
