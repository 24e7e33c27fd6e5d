#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/passive/dop853.h"
#include "engine/passive/region_dynamics.h"
#include "engine/passive/stop_forces.h"

namespace hazumi {

// Hits of one stop that follow each other more closely than this are told as one [s]: two joints
// that press on their stops in turn hit them thousands of times.
constexpr double kChatterGap = 1.0 / 30.0;

// A hinge that reached a stop, `count` times from `time` to `last_time` [s].
struct StopHit {
  double time, last_time;
  long count;
  int hinge;  // free hinge
};

// Why a solver cannot go on.
struct ExactFailure {
  int hinge;
  enum class Cause { kStepTooSmall, kTooManyEvaluations } cause;
};

// The passive motion of one group of free joints in continuous time [METHOD 2.1], with its error
// under control: steps of order 8 whose size follows the error, ball joints as quaternions, stops
// found inside the steps, hit inelastically and let go when they would have to pull.
//
// Between Advance and the next one the solver is "in" the accepted step: Sample looks inside it.
class ExactSolver {
 public:
  // `dynamics` must outlive the solver. `lower`, `upper`: stops by free hinge [rad].
  ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper);

  // Error of one step: of an angle [rad]; of a rate, 1/s of it times kRateScale.
  void SetTolerance(double radians) { tolerance_ = radians; }
  static constexpr double kRateScale = 20.0;  // [1/s]
  // [s]; none unless set.
  void SetLongestStep(double seconds) { longest_step_ = seconds; }

  // Begins at these angles and rates of the free hinges. A hinge that is outside its stops has a
  // stop where it is until it has come inside.
  void Start(double t, const VecX& q, const VecX& qd, const PointMotion& anchor = {});
  // Goes on from the end of the step with driven curves (or locks, or masses) that have changed.
  void Restart();
  // A pin that moved with v_pin [m/s] was stopped dead: the hinges feel the impulse.
  void FeelPin(const Vec3& v_pin);

  // One step, at most to `end`; it ends early where a stop is hit or lets go, which happens at the
  // beginning of the next step.
  std::optional<ExactFailure> Advance(double end);

  double step_start() const { return step_.start_time(); }
  double time() const { return time_; }
  // Angles and rates of the free hinges at t in [step_start, time]; at `time` itself from the left.
  void Sample(double t, VecX* q, VecX* qd);
  // Of the centre of mass at the same time, if the fall is solved along (RegionDynamics).
  const PointMotion& SampledAnchor() const { return dynamics_->anchor(); }
  // At `time`, before impacts.
  const VecX& q() const { return q_; }
  const VecX& qd() const { return qd_; }
  // Energy and powers at t in [step_start, time], from the left.
  EnergyFlow Energy(double t);

  // Hits since the last call.
  std::vector<StopHit> TakeHits();
  long steps() const { return steps_; }

 private:
  static constexpr double kTouch = 1e-10;     // at a stop [rad]
  static constexpr double kSameTime = 1e-13;  // [s]

  // A hinge goes out.
  struct Crossing {
    double time;
    int hinge;
  };
  // Where a ball joint is nearest to a pole.
  struct Pole {
    double time;
    int node;
  };

  // Steps and events (exact_solver.cpp).
  void MakeEventHappen();
  void ResolveStops(const Vec3& v_pin);
  int FindSides(bool with_impulse);
  void AddHit(int hinge);
  void Collide(const Vec3& v_pin);
  void Settle();
  void Relock();
  void SetScale();
  void TakeState(const double* y);
  double FirstStep(double end) const;
  double Growth(double error) const;
  bool Step(double end, std::optional<ExactFailure>* failure);
  ExactFailure Failure(ExactFailure::Cause cause) const;
  void MakeDense();
  void WidenStops();
  void TightenStops();
  double Outside(int hinge, const VecX& q) const;

  // Hits and poles (exact_hits.cpp).
  bool FindSuspects();
  void SampleSuspects(double t, VecX* q, VecX* qd);
  bool FindHit();
  std::optional<Crossing> FirstCrossing(double before, double t);
  void EndStepAt(double t);
  std::optional<Pole> FindPole(double before, double t);
  bool Leaves(const Pole& pole);
  std::optional<Pole> PoleAt(const Crossing& hit) const;
  double PoleRate(const Pole& pole) const;
  void GoOnFromCut();
  double Beyond(int hinge, int side, double q) const;
  std::optional<double> FindCrossing(int hinge, int side, double before, double t);
  double CrossingTime(int hinge, int side, double inside, double outside);

  // Releases (exact_releases.cpp).
  std::optional<double> FindRelease();
  void EndStepAtRelease(double t);
  double Pull(double t);
  double StrongestPull() const;
  std::optional<double> FindPull(double a, double fa, double b, double fb, int halvings);
  bool StaysBelow(double a, double fa, double fm, double b, double fb);
  double ReleaseTime(double a, double fa, double b, double fb);

  RegionDynamics* dynamics_;
  VecX lower_, upper_;          // as given
  VecX lower_now_, upper_now_;  // widened to where the hinge started
  double tolerance_ = 1e-6;
  double longest_step_ = std::numeric_limits<double>::infinity();
  Dop853 step_;
  double time_ = 0.0, first_start_ = 0.0, next_h_ = 0.0;
  double last_error_ = 1.0;  // of the step before, in units of the tolerance
  VecX q_, qd_;              // at time_
  PointMotion anchor_;       // at time_
  VecX q_start_, qd_start_;  // at the start of the step
  VecX look_q_, look_qd_, before_q_, before_qd_;
  VecX sample_q_, sample_qd_, y_, scale_;
  double after_release_ = 0.0;  // a moment after a stop lets go at time_, else long before
  VecX after_q_, after_qd_;     // at that moment
  StopForces stops_;
  std::vector<int> side_;  // by hinge: the stop it is at, as StopSolver
  std::vector<char> locked_, sticks_, held_after_;
  std::vector<char> fixed_;  // no room between the stops
  bool any_limits_ = false, any_locked_ = false;
  double touch_rate() const { return 30.0 * touch_; }  // slow enough to count as at rest [rad/s]
  std::vector<int> suspects_;                          // nodes
  std::vector<StopHit> hits_;
  std::vector<int> last_hit_;   // by hinge: its latest in hits_; -1: none
  std::vector<double> recent_;  // times of events, for telling chatter
  double pull_before_ = 0.0;    // strongest pull at the start of the step [N m]
  double touch_ = 0.0;          // how near a stop counts as at it [rad]
  bool has_event_ = false;
  bool follows_event_ = false;  // the step begins with rates or forces that have jumped
  bool is_cut_ = false;         // the step was ended at time_ without an event
  long steps_ = 0;
};

}  // namespace hazumi
