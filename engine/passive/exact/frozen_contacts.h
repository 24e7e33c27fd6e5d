#pragma once

#include <memory>
#include <tuple>
#include <vector>

#include "engine/passive/exact/dense_step_problem.h"
#include "engine/passive/exact/hinge_state.h"
#include "engine/passive/exact/impact_log.h"
#include "engine/passive/exact/limit_range.h"

namespace hazumi {

// Where contacts and limits change again and again, as they do when a body tumbles to rest, they
// are not followed from event to event: what they give is found for a short while at a time, and
// kept for as long. [METHOD 12.4]
class FrozenContacts {
 public:
  // Both must outlive it.
  FrozenContacts(RegionDynamics* dynamics, const LimitRange* limits);

  // Another motion.
  void Begin();
  // Whether anything is inside something: it is let out slowly, with contacts frozen.
  bool IsAnyInside(double t, const HingeState& state);
  // Contacts begin to come too fast at t: sooner after they were let go the last time, they are
  // kept for longer.
  void Enter(double t);
  // They are let go at t.
  void Leave(double t);
  // For a while from t on: rates after the impacts of all that would be hit within it, and
  // RegionDynamics::frozen().
  void Set(double t, HingeState* state, ImpactLog* log);
  // Whether its forces give energy in a step of so many seconds that ends so.
  bool GivesTooMuch(double seconds, const RegionState& state) const;
  // The next while is to be half as long as the latest. False: that is too short.
  bool Halve();
  // What gives energy in the shortest while does not act in it: a limit next to a pole.
  void GiveNothing();
  // Of the latest while [s].
  double length() const { return h_; }
  // By how much the impacts changed velocities of the outer motion (OuterMotion) [m/s, rad/s].
  const VecX& kick() const { return kick_; }
  // Returns whether event-driven mode can resume: no recent impact, and the same contacts and
  // limits active. Contacts that are solved by the tree have no event-driven mode; all of them have
  // to separate first.
  bool is_calm() const {
    const bool may_follow = !dynamics_->solves_contacts_by_tree() || pushes_.empty();
    return calm_steps_ >= calm_enough_ && may_follow;
  }

 private:
  // What pushes: a capsule's obstacle, or with no capsule (-1) a hinge's limit.
  struct Pushing {
    int capsule, other;
    bool slides;
    bool operator==(const Pushing&) const = default;
    bool operator<(const Pushing& of) const {
      return std::tie(capsule, other, slides) < std::tie(of.capsule, of.other, of.slides);
    }
  };

  void GiveWay();
  void SweepUpTo(double most, const VecX& start);
  void ListNear(double t, const HingeState& state);
  bool Strike(double t, HingeState* state, ImpactLog* log);
  void TellOfContacts(double t, const VecX& came, ImpactLog* log) const;
  void Press(double t, const HingeState& state);
  void SoftenBySprings();
  void KeepSprings(const VecX& x_0, const RegionState& state);
  void Keep(const VecX& impulses);
  VecX LastForces() const;
  double SpeedFor(double s, double fastest_out) const;
  double GapOf(const ConstraintRow& row) const;
  double RoomOf(int hinge, const VecX& q) const;
  void YieldMore();

  RegionDynamics* dynamics_;
  const LimitRange* limits_;
  std::unique_ptr<StepProblem> problem_;
  DenseStepProblem* dense_ = nullptr;  // same as problem_; null if contacts are solved by the tree
  std::vector<int> side_;              // limit that each hinge may reach, as in LimitSolver
  VecX torques_;                       // latest torques of limits, by hinge [N m]
  std::vector<Pushing> pushes_;
  std::vector<JointSpring> springs_;  // implicit springs
  VecX kick_;
  bool is_inside_ = false, is_deep_ = false;  // something is inside, or more than that
  bool has_no_room_ = false;  // contact forces reached their bound in the latest step
  double least_yield_ = RegionDynamics::kBlocked;  // smallest compliance of constraints
  int calm_steps_ = 0, calm_enough_ = 0;
  double left_ = 0.0;             // when [s]
  double start_ = 0.0, h_ = 0.0;  // of the latest while [s]
  double longest_ = 0.0;          // that the next one may be [s]
  double kinetic_ = 0.0;          // where the latest began [J]
  double fastest_ = 0.0;          // of what may touch [m/s]
};

}  // namespace hazumi
