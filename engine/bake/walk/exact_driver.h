#pragma once

#include <atomic>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/handover/region_start.h"
#include "engine/bake/island_solution.h"
#include "engine/bake/motion.h"
#include "engine/bake/moving_base_cache.h"
#include "engine/bake/pose/root_placement.h"
#include "engine/bake/thread_pool.h"
#include "engine/bake/walk/energy_account.h"
#include "engine/bake/walk/held_together.h"
#include "engine/bake/walk/own_pairs.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Moves the joints of all exact regions that are active at one time, in continuous time. Each
// island of joints that feel each other takes its own steps, and beside it a control solution with
// a coarser tolerance: how far the two get apart tells how far the solution may be off.
class ExactDriver {
 public:
  // `active`: indices of Animation::regions, `starts`: of those with springs. `figure`, `pool` and
  // `known`, the logs of earlier bakes, must outlive the driver; `known` null: no logs are kept.
  // `sharpness`: divides the tolerances of single steps. `broken`: constraints that do not act, by
  // index of the animation's.
  ExactDriver(const Animation& animation, const Figure& figure, std::vector<int> active,
              const std::map<int, RegionStart>& starts, double sharpness, std::vector<int> broken,
              const KnownLogs* known, ThreadPool* pool);

  const std::vector<int>& active() const { return active_; }
  bool is_free(Coordinate c) const { return region_of_[c] >= 0; }
  // By index of the animation's, of a free joint.
  int RegionOf(JointIndex j) const { return active_[region_of_[j.value()]]; }
  // Free in name only: it keeps its angle.
  bool is_frozen(Coordinate c) const;

  bool has_contacts() const { return has_contacts_; }
  // Whether it moves the loose objects of the state that it began with.
  bool moves_loose() const;
  // For the account of energy: those that it moved up to where it began, and those since.
  void ExchangeLoose(const std::vector<LooseObject>& before, const std::vector<LooseObject>& now);
  // Whether what a joint carries touches things in the scene.
  bool Touches(JointIndex j) const;
  // Links that stay out of each other, as a region asks that moves one of them.
  const std::vector<LinkPair>& own_pairs() const { return own_pairs_; }
  // By contacts, where a placement by gravity leaves it to them.
  bool places_root() const;

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
  std::vector<Hit> TakeHits();
  // Touch-downs since the last call.
  std::vector<TouchDown> TakeTouches();

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
  // Those that broke since the last call: they do not act any more.
  std::vector<ConstraintBreak> TakeBreaks();

  // Compares with the control solutions at time t.
  void Estimate(double t);
  // Estimate of the error of an active region, by index in active(). A body that tumbles in the
  // end, in time-stepping mode, is estimated for as long as its estimate was within the tolerance.
  struct RegionEstimate {
    double error = 0.0;                                      // the largest up to there [rad]
    double until = std::numeric_limits<double>::infinity();  // [s]
    // Time from which the events of the solution and the control solution differ [s].
    double branches_from = std::numeric_limits<double>::infinity();
  };
  RegionEstimate EstimateOf(size_t region) const;
  // Returns the largest estimate so far, also while the figure tumbles [rad].
  double LargestEstimateOf(size_t region) const { return estimated_[region].error; }
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
    IslandConstraints held;  // of the task
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

  void ListOwnPairs();
  // The region that moves what a joint carries; none: null.
  const DynamicsRegion* Carrying(JointIndex j) const;
  ModelRequest RequestFor(const RotationState& state, const RootHold& hold,
                          const DrivenMotion& driven) const;
  // Of an island that begins with a stretch whose middle is at `t` [s].
  IslandTask TaskFor(RegionModel model, double t, const std::vector<LooseObject>& loose,
                     IslandConstraints* constraints) const;
  void AddDrives(IslandTask* task) const;
  double StepToleranceFor(const RegionModel& model) const;
  void AccountForMass(const std::vector<RegionModel>& models);
  void FinishIslands();
  void AppendLogs(IslandLogs* logs) const;
  std::optional<Failure> FirstFailure() const;
  void LeaveControl(Island* island);
  void NoteBranches(const Island& island, double t);
  // Of solutions and control solutions.
  template <typename Action>
  void ForEachSolution(Action&& action);

  const Animation& animation_;
  const Figure& figure_;
  std::vector<int> active_;
  double sharpness_;
  const KnownLogs* known_;
  ThreadPool* pool_;
  MovingBaseCache moving_bases_;
  bool has_contacts_ = false;  // any of the regions
  std::vector<LinkPair> own_pairs_;
  std::vector<int> region_of_;    // by Coordinate: index in active_, -1: not free
  std::vector<double> friction_;  // by Coordinate: factor
  // By Coordinate, if there are any drives: what drives a joint.
  std::vector<const hazumi::Drive*> drives_;
  std::vector<Spring> springs_;
  std::vector<int> broken_;
  ModelRequest request_;  // of the islands as they are
  std::vector<Island> islands_;
  struct Estimated {
    double error = 0.0, within = 0.0;  // the largest, and of those before one beyond the tolerance
    double within_until = 0.0;         // [s]
    bool is_beyond = false;
    double time_stepping_from = std::numeric_limits<double>::infinity();  // [s]
    double branches_from = std::numeric_limits<double>::infinity();       // [s]
  };
  std::vector<Estimated> estimated_;  // by index in active()
  EnergyAccount energy_;
  Finished finished_;
};

}  // namespace hazumi
