#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/island_solution.h"
#include "engine/bake/motion.h"
#include "engine/bake/moving_base_cache.h"
#include "engine/bake/pose/root_placement.h"
#include "engine/bake/thread_pool.h"
#include "engine/bake/walk/active_regions.h"
#include "engine/bake/walk/energy_account.h"
#include "engine/bake/walk/region_estimates.h"

namespace hazumi {

// Moves the joints of all exact regions that are active at one time, in continuous time. Each
// island of joints that feel each other takes its own steps, and beside it a control solution with
// a coarser tolerance: how far the two get apart tells how far the solution may be off.
class ExactDriver {
 public:
  // `pool` and `known`, the logs of earlier bakes, must outlive the driver; `known` null: no logs
  // are kept. `sharpness`: divides the tolerances of single steps. `broken`: constraints that do
  // not act, by index of the animation's.
  ExactDriver(ActiveRegions regions, double sharpness, std::vector<int> broken,
              const KnownLogs* known, ThreadPool* pool);
  ExactDriver(const ExactDriver&) = delete;
  ExactDriver& operator=(const ExactDriver&) = delete;

  const ActiveRegions& regions() const { return regions_; }
  // Whether it moves the loose objects of the state that it began with.
  bool moves_loose() const;
  // For the account of energy: those that it moved up to where it began, and those since.
  void ExchangeLoose(const std::vector<LooseObject>& before, const std::vector<LooseObject>& now);

  // Begins at t, or goes on there under other circumstances, from the motion at t. `driven` is
  // smooth up to `end`. Control solutions go on from `control` where a coordinate was free before.
  void Begin(double t, double end, const RotationState& state, const RotationState& control,
             const RootHold& hold, const DrivenMotion& driven);
  // Goes on with new curves.
  void Drive(double end, const RotationState& state, const DrivenMotion& driven);
  // An impulse acts on the figure, which is at `state`, before it begins: `state` changes. False if
  // no free joint carries the point where it acts.
  bool Push(const PushForce& push, const RootHold& hold, RotationState* state);

  struct Failure {
    JointIndex joint;
    std::string cause;
    double time;  // up to which it went well [s]
  };
  // Steps every island that has not got beyond t, at most to `end`.
  std::optional<Failure> Advance(double t, double end);
  // Solves all islands up to `end` at once, on as many threads as there are; afterwards they can be
  // sampled at `times`, which rise and include `end`, up to a failure. Gives up where `cancel` is
  // set.
  std::optional<Failure> AdvanceAhead(const std::vector<double>& times, double end,
                                      const std::atomic<bool>* cancel);
  // Whether samples tell where a figure in flight is: forces from outside push it off its parabola.
  bool solves_fall() const;
  // How far all islands have got [s].
  double time() const;
  // The free coordinates at a time between the last two values of time().
  void Sample(double t, RotationState* state, Gaps gaps = Gaps::kClosed);
  // The control solutions' at time().
  void SampleControl(double t, RotationState* state);

  // Of all free coordinates at a time that they can be sampled at, or with which they begin next,
  // by Coordinate [rad/s, rad/s^2]; others are left. Returns that of the centre of mass where it is
  // solved along.
  std::optional<Vec3> Accelerations(double t, VecX* rates, VecX* accelerations);

  // Returns how far two sets of angles, as from Estimate, are apart: by active region the largest
  // distance of a joint [rad].
  std::vector<double> Distances(const VecX& angles, const VecX& others) const;

  // Adds up energies and work to t, which all islands have reached; an account is kept from the
  // first call on. `is_cut`: the driver begins anew at t.
  void Account(double t, bool is_cut);
  // None if the root's coupling changed on the way: kinetic energy is not the same thing then.
  std::optional<EnergyBalance> energy() const { return energy_.balance(); }

  struct Hit {  // as LimitHit
    double time, last_time;
    long count;
    Coordinate coordinate;
  };
  struct Events {
    std::vector<Hit> hits;
    std::vector<TouchDown> touches;
    std::vector<ConstraintBreak> breaks;  // by index of the animation's constraints
  };
  // Returns the events since the last call. Constraints that broke do not act any more.
  Events TakeEvents();

  // Free joints without mass beyond them: forces do not move these joints. A ball joint is listed
  // by its first hinge.
  std::vector<JointIndex> WeightlessJoints() const;

  // Constraints that act, by index of the animation's.
  std::vector<int> constraints() const;
  // What each does, by index of the animation's, at a time that islands can be sampled at.
  std::vector<ConstraintPush> ConstraintPushes(double t);
  // Springs that give all they can at such a time: of ball joints the first hinge.
  struct SpentSpring {
    JointIndex joint;
    SpentDrive drive;
  };
  std::vector<SpentSpring> SpentSprings(double t);
  // What pushes where, at such a time.
  SceneContacts ContactsAt(double t);

  // Compares with the control solutions at time t. Returns the angles there, by Coordinate [rad]; 0
  // for those that are not free.
  VecX Estimate(double t);
  const RegionEstimates& estimates() const { return estimates_; }

  long evaluations() const;
  long steps() const;
  Work work() const;
  // First joint of the island that takes the most work.
  JointIndex CostliestJoint() const;
  std::vector<int> island_sizes() const;
  int num_bodies() const;
  // It took to solve all islands [us], whenever that was.
  double microseconds() const;
  // Those of all islands since the first Begin; of ended ones once only.
  void MoveLogsTo(IslandLogs* logs);

 private:
  struct Island {
    IslandSolution solution, control;
    IslandConstraints held;  // constraints of the task
    // Time-stepping mode has not been entered: the control solution tells something about it, and
    // runs.
    bool has_control = true;
  };
  // Of islands that are no more.
  struct Finished {
    long evaluations = 0, steps = 0;
    Work work;
    double microseconds = 0.0;
    IslandLogs logs;
  };

  void AccountForMass(const std::vector<RegionModel>& models);
  void FinishIslands();
  void AppendLogs(IslandLogs* logs) const;
  std::optional<Failure> FirstFailure() const;
  void LeaveControl(Island* island);
  void NoteBranches(const Island& island, double t);
  // Of solutions and control solutions.
  template <typename Action>
  void ForEachSolution(Action&& action);

  const ActiveRegions regions_;
  double sharpness_;
  const KnownLogs* known_;
  ThreadPool* pool_;
  MovingBaseCache moving_bases_;
  std::vector<int> broken_;
  ModelRequest request_;  // of the islands as they are
  std::vector<Island> islands_;
  RegionEstimates estimates_;
  EnergyAccount energy_;
  Finished finished_;
};

}  // namespace hazumi
