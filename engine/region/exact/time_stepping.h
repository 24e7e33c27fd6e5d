#pragma once

#include <memory>
#include <tuple>
#include <variant>
#include <vector>

#include "engine/region/exact/dense_step_problem.h"
#include "engine/region/exact/impact_log.h"
#include "engine/region/exact/implicit_springs.h"
#include "engine/region/exact/limit_range.h"

namespace hazumi {

// Time-stepping mode [METHOD 12.4]: where contacts and limits change again and again, as they do
// when a body tumbles to rest, their forces are found for one short step at a time, and constant
// during it. The other mode follows contacts from event to event (ActiveLimits, ContactSearch).
class TimeStepping {
 public:
  // Both must outlive this object.
  TimeStepping(RegionDynamics* dynamics, const LimitRange* limits);

  // Begins another motion.
  void Begin();
  // Returns whether anything is inside something: it is let out slowly, in this mode.
  bool IsAnyInside(double t, const HingeState& state);
  // Enters the mode at t. Soon after the mode was left, it is kept for longer.
  void Enter(double t);
  // Leaves the mode at t.
  void Leave(double t);
  // Finds the next step from t on: changes the state by the impacts of all that would be hit within
  // it, and sets the forces of the mode (RegionMode::constant).
  void Set(double t, HingeState* state, ImpactLog* log);
  // Returns whether these forces add energy in a step of so many seconds that ends so.
  bool GivesTooMuch(double seconds, const RegionState& state) const;
  // Halves the length of the next step. Returns false if that is too short.
  bool Halve();
  // Drops the forces of the present step, for a limit next to a pole that adds energy in the
  // shortest one.
  void GiveNothing();
  // Length of the present step [s].
  double length() const { return h_; }
  // Returns whether event-driven mode can resume: no recent impact, and the same contacts and
  // limits active. Contacts that are solved by tree have no event-driven mode; all of them have to
  // separate first.
  bool is_calm() const {
    const bool may_follow = !dynamics_->solves_contacts_by_tree() || pushing_.empty();
    return calm_steps_ >= calm_enough_ && may_follow;
  }

 private:
  // A contact, or the limit of a hinge, that has a force.
  struct PushingContact {
    int capsule = 0;
    ContactPartner partner;
    bool slides = false;
    bool operator==(const PushingContact&) const = default;
    bool operator<(const PushingContact& other) const {
      return std::tie(capsule, partner, slides) <
             std::tie(other.capsule, other.partner, other.slides);
    }
  };
  struct PushingLimit {
    int hinge = 0;
    bool operator==(const PushingLimit&) const = default;
    bool operator<(const PushingLimit& other) const { return hinge < other.hinge; }
  };
  using Pushing = std::variant<PushingContact, PushingLimit>;

  void AddCompliance();
  void SweepUpTo(double most, const VecX& start);
  void ListNear(double t, const HingeState& state);
  bool Strike(double t, HingeState* state, ImpactLog* log);
  void TellOfContacts(double t, const VecX& came, ImpactLog* log) const;
  void Press(double t, const HingeState& state);
  void Keep(const VecX& impulses, const RegionState& state);
  VecX LastForces() const;
  double SpeedFor(double s, double fastest_out) const;
  double GapOf(const ConstraintRow& row) const;
  double RoomOf(int hinge, const VecX& q) const;
  void AllowMoreCompliance();
  const std::vector<ConstraintRow>& rows() const { return dynamics_->rows().rows(); }
  ContactSet& contacts() { return dynamics_->mode().contacts; }
  const ContactSet& contacts() const { return dynamics_->mode().contacts; }

  RegionDynamics* dynamics_;
  const LimitRange* limits_;
  std::unique_ptr<StepProblem> problem_;
  DenseStepProblem* dense_ = nullptr;  // same as problem_; null if contacts are solved by tree
  std::vector<int> side_;              // limit that each hinge may reach, as in LimitSolver
  VecX torques_;                       // latest torques of limits, by hinge [N m]
  std::vector<Pushing> pushing_;
  ImplicitSprings springs_;
  bool is_inside_ = false, is_deep_ = false;  // something is inside, or more than that
  bool has_no_room_ = false;  // contact forces reached their bound in the latest step
  double least_compliance_ = RegionMode::kBlocked;  // of constraints
  int calm_steps_ = 0, calm_enough_ = 0;
  double left_ = 0.0;             // when the mode was left [s]
  double start_ = 0.0, h_ = 0.0;  // of the present step [s]
  double longest_ = 0.0;          // length of the next step at most [s]
  double kinetic_ = 0.0;          // at the start of the present step [J]
  double fastest_ = 0.0;          // speed of what may touch [m/s]
};

}  // namespace hazumi
