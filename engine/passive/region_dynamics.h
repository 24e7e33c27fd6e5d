#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/passive/constraints/constraint_rows.h"
#include "engine/passive/constraints/row_forces.h"
#include "engine/passive/contact/contact_push.h"
#include "engine/passive/contact/contact_set.h"
#include "engine/passive/contact/frozen_forces.h"
#include "engine/passive/dense_equations.h"
#include "engine/passive/exact/limit_rows.h"
#include "engine/passive/forces/force_law.h"
#include "engine/passive/moving_base.h"
#include "engine/passive/node_motion.h"
#include "engine/passive/outer_motion.h"
#include "engine/passive/region_layout.h"
#include "engine/passive/tree_equations.h"
#include "engine/passive/tree_impulses.h"
#include "engine/passive/work.h"

namespace hazumi {

// The equations of motion of a region model in continuous time [METHOD 2.2]:
//   M(q) x = -b(q, v, t),   v' = x + r(q, v, t)
// with v the velocities of a RegionLayout, b what motion, gravity and the forces of all laws ask
// for, and r what the laws add that are rules for accelerations, as friction is. World axes
// throughout; points from the root's origin.

// Energy of the bodies that a model moves, and the power that flows into it. Where the root flies,
// as seen from the centre of mass, unless it may touch things; else potential energy counts from
// the height of the world's origin, or of the pin.
struct EnergyFlow {
  double kinetic = 0.0, potential = 0.0;  // [J]
  double keyed = 0.0;                     // [W], by driven joints and the motion of the moving base
  struct OfLaw {
    std::string name;
    double power;  // [W], negative where energy is lost
  };
  std::vector<OfLaw> laws;
};

class RegionDynamics {
 public:
  // `gravity`: along -z [m/s^2].
  RegionDynamics(RegionModel model, ForceLaws laws, double gravity,
                 std::vector<ConstraintSpec> constraints = {}, ContactSpec contacts = {});

  const RegionModel& model() const { return model_; }
  double gravity() const { return gravity_; }
  const RegionLayout& layout() const { return layout_; }
  const std::vector<FreeHinge>& hinges() const { return layout_.hinges(); }
  int num_hinges() const { return layout_.num_hinges(); }
  // Where a pinned root answers, islands of up to so many free hinges are solved the dense way,
  // which takes n^3, larger ones by articulated bodies, in O(n).
  void SetMostDense(int hinges) { most_dense_ = hinges; }

  // The curves must outlive their use, and move smoothly from `start` to `end` [s].
  void SetDriven(const DrivenMotion* driven, double start, double end) {
    SetCurves(driven, start);
    if (needs_moving_base()) UseMovingBase(FitMovingBase(start, end));
  }
  // The same in parts, so that dynamics whose carriers are moved in the same way, by the nodes
  // before first_moved(), can share a moving base.
  void SetCurves(const DrivenMotion* driven, double start);
  bool needs_moving_base() const { return first_moved_ > 0 && !is_carrier_still_ && !has_outer_; }
  int first_moved() const { return first_moved_; }
  // Fits the moving base up to `end`, and beyond for a step that may be cut there.
  std::shared_ptr<const MovingBase> FitMovingBase(double start, double end);
  // Returns the time up to which the curves are polynomials, for a motion that is requested up to
  // `end` [s].
  double SmoothUntil(double end) const { return std::max(end, driven_->holds_until); }
  void UseMovingBase(std::shared_ptr<const MovingBase> moving_base) {
    moving_base_ = std::move(moving_base);
  }
  // In flight, with laws that act from outside, or constraints, the fall is solved along: the state
  // goes on with the centre of mass and its velocity. It ends with balls.
  bool is_pushed_in_flight() const {
    return has_outer_ && model_.coupling == RootCoupling::kFlight;
  }
  const OuterLayout& outer_layout() const { return outer_layout_; }
  // Whether anything acts but gravity and what carries it.
  bool is_pushed() const { return has_forces_ || has_rows_; }
  int state_size() const { return layout_.state_size() + outer_layout_.size(); }
  // What the figure is placed by where nothing prescribes it: its pin, which rests, or in flight
  // its centre of mass; and balls. Read by laws that act from outside. What a state has of it is
  // that of the state which was looked at last.
  void SetOuter(const OuterMotion& outer) { outer_ = outer; }
  const OuterMotion& outer() const { return outer_; }
  // Impulses have made its velocities jump.
  void JumpOuter(const VecX& by) { outer_.Jump(by); }
  void SetOuterOf(const double* y) { outer_layout_.Unpack(y + layout_.state_size(), &outer_); }
  // Its part of a state, if it has one.
  void PackOuter(double* y) const { outer_layout_.Pack(outer_, y + layout_.state_size()); }
  // Of balls [J].
  double KineticOfBalls() const;

  // Locks some free hinges at these angles [rad]; by free hinge.
  void SetLocked(const std::vector<char>& locked, const VecX& angles) {
    layout_.SetLocked(locked, angles);
  }

  // dy/dt at time t [s]. Counts as one evaluation.
  void Derivative(double t, const double* y, double* dy);

  // The same for reports, not counted.
  void Look(double t, const double* y, double* dy);

  // M (k x k) and b (k) with the rates of all free hinges, locked or not, as velocities: what
  // limits press and what impacts do. Counts as one evaluation.
  void AssembleHinges(double t, const VecX& q, const VecX& qd);
  // The same of an island that is large, and not solved the dense way: of some hinges alone, with
  // the others following freely. Counts as one evaluation.
  bool is_large() const {
    if (contacts_by_tree_) return true;
    return !has_rows_ && model_.num_free > most_dense_ && UsesArticulatedBodies();
  }
  void AssembleSome(const std::vector<int>& hinges, double t, const VecX& q, const VecX& qd);
  // Returns whether contacts and limits of the island are solved together without M: for large
  // islands with contacts with fixed obstacles only, in time-stepping mode. [METHOD 12.10]
  bool solves_contacts_by_tree() const { return contacts_by_tree_; }
  // Assembles the rows of such an island for the rates of all free hinges. x_0: accelerations of
  // the hinges without rules; of_rows: those of the rows with rules. Counts as one evaluation.
  void AssembleByTree(double t, const VecX& q, const VecX& qd, VecX* x_0, VecX* of_rows);
  // Begins impulses for the same q. Requires AssembleByTree.
  void BeginImpulses(TreeImpulses* impulses) const {
    impulses->Begin(hinge_layout_, kinematics_.motion(), tree_.bodies());
  }
  // Kinetic energy for rates of the free hinges, in flight relative to the centre of mass [J].
  // Requires AssembleByTree.
  double KineticEnergyOf(const VecX& qd) const;
  // Assembled last.
  const MatX& M() const { return assembled().M; }
  const VecX& b() const { return assembled().b; }

  // After AssembleHinges, as DenseEquations has it; after AssembleSome, as TreeEquations.
  void PinImpulse(const Vec3& v_pin, VecX* impulse) const { dense_.PinImpulse(v_pin, impulse); }
  VecX JumpOf(const VecX& impulses) const { return tree_.JumpOf(impulses); }
  VecX JumpOfPin(const Vec3& v_pin) {
    return tree_.JumpOfPin(hinge_layout_, kinematics_.motion(), v_pin);
  }

  // Sets the smallest compliance of constraints from now on (YieldOf): kBlocked where limits hold
  // or may hold hinges, more where contacts leave no feasible motion.
  static constexpr double kBlocked = 0.01;
  void SetLeastYield(double least) { least_yield_ = least; }
  // Constraints keep their ends together, and contacts apart; where a pinned root answers, however
  // large the island is, the dense way.
  ConstraintRows& constraints() { return rows_; }
  const ConstraintRows& constraints() const { return rows_; }
  ContactSet& contacts() { return contacts_; }
  const ContactSet& contacts() const { return contacts_; }
  // Act on top of everything else.
  FrozenForces& frozen() { return frozen_; }
  // After AssembleHinges: adds a moment that gives the hinges these torques [N m].
  void Freeze(const VecX& torques);
  // Returns whether springs are implicit in time-stepping mode.
  bool has_implicit_springs() const { return contacts_.rules().stands_on_springs && has_springs_; }
  // Springs in joints at this state. Requires AssembleHinges at the same state.
  std::vector<JointSpring> Springs(const RegionState& state) const;
  // Axes of the hinges of a spring, world.
  Eigen::Matrix3Xd AxesOf(const JointSpring& spring) const;
  int FirstHingeOf(const JointSpring& spring) const {
    return hinge_layout_.node(spring.node).first_hinge;
  }
  // Angular velocity of the node of a spring relative to the parent [rad/s].
  Vec3 TurningOf(const JointSpring& spring) const;
  // Holds these spring moments constant in time-stepping mode, within their limits.
  void FreezeSprings(const std::vector<JointSpring>& springs, const RegionState& state);
  // After the nodes have been placed: of a contact's row, with a force on its end a.
  FrozenForces::Push PushOf(const ConstraintRow& row, const small::V3& force) const;
  // Others' work on this island, in evaluations.
  void AddWork(const Work& evaluations) { other_work_ += evaluations; }
  bool closes_gaps() const { return rows_.any_closed() || contacts_.any_closed(); }
  // Where the nodes are and how they move in state y; not counted as an evaluation.
  RegionState PlaceAt(double t, const double* y);
  // Again, after it with the same.
  RegionState PlacedAt(double t, const double* y) const {
    return StateAt(t, layout_, y, y + layout_.num_positions());
  }
  // The same of all hinges, locked or not; and again, after it or AssembleHinges with the same.
  RegionState PlaceHinges(double t, const VecX& q, const VecX& qd);
  RegionState PlacedHinges(double t, const VecX& q, const VecX& qd) const {
    return StateAt(t, hinge_layout_, q.data(), qd.data());
  }
  // Forces of their rows in the state that was looked at last [N, N m].
  const VecX& row_forces() const { return row_forces_; }
  // After AssembleHinges: what limits need of the rows; null if there are none.
  const LimitRows* RowsOfForces() const { return has_any_rows() ? &hinge_rows_ : nullptr; }
  const LimitRows* RowsOfImpulses() const { return has_any_rows() ? &hinge_row_rates_ : nullptr; }
  const std::vector<ConstraintRow>& rows() const { return rows_.rows(); }
  // How far the forces of contacts are beyond what they can be, in the state that was looked at
  // last, as a part of what they push with in all.
  double ContactExcess() const;
  // How firmly constraints that are kept closed, as they were last looked at, hold, in as many
  // directions as they have rows, the least one first: about 1 where it is as firm as can be, 0
  // where it is none, as along a limb that is straight. And the constraint that says most of it.
  struct Hold {
    double firmness;
    int constraint;
  };
  std::vector<Hold> Holds() const;
  // Drives that give all they can at angles q and rates qd by free hinge.
  std::vector<SpentDrive> SpentDrives(double t, const VecX& q, const VecX& qd);
  // What pushes there: where contacts are closed, and what is frozen.
  std::vector<ContactPush> ContactPushes() const;
  // By how much impulses of the rows change velocities of the outer motion, as OuterMotion has
  // them: that of the centre of mass in flight, and of balls [m/s, rad/s].
  VecX KickOf(const VecX& impulses) const;
  // Moves a state to where the rows that have no gap to close have none, and none opens: the least
  // way, as masses count. Returns what is left [m, rad]. Counts as two evaluations. Where contacts
  // have no room what is left of their gaps is theirs from now on, unless it is `only_looked_at`.
  double CloseGaps(double t, double* y, bool only_looked_at = false);

  // At time t in state y. Each power is found from the forces in the joints, not from the others.
  EnergyFlow MeasureEnergy(double t, const double* y);

  // Of all laws, as ForceLaw has them, in that state.
  bool has_kinks() const { return frozen_.holds_springs ? has_other_kinks_ : has_kinks_; }
  void KinksIn(const RegionState& state, std::vector<double>* kinks) const {
    kinks->clear();
    for (const auto& law : laws_) {
      if (!frozen_.holds_springs || !law->is_spring()) law->AppendKinks(state, kinks);
    }
  }
  // Of all laws, as ForceLaw has it [1/s].
  double FastestRate() const;

  long evaluations() const { return evaluations_; }
  // What they took, in evaluations of accelerations: the equations of all hinges, with what limits
  // make of them, take about one more for each 250 entries of their matrix.
  Work work() const {
    constexpr double kSample = 0.4;  // cost of a contact point in evaluations of one body
    const double entries = static_cast<double>(num_hinges()) * num_hinges();
    Work work = other_work_;
    work.searches +=
        kSample / std::max(1, model_.num_bodies) * static_cast<double>(contacts_.num_samples());
    work.motion += static_cast<double>(evaluations_);
    work.limits += entries / 250.0 * num_assembled_;
    return work;
  }

 private:
  const IslandEquations& assembled() const {
    return assembled_some_ ? tree_.some() : dense_.equations();
  }
  bool UsesArticulatedBodies() const;
  bool SolvesContactsByTree() const;
  void SolveWithoutRows(const RegionLayout& layout, double* x);
  void Move(double t, const RegionLayout& layout, const double* positions,
            const double* velocities);
  bool IsCarrierStill() const;
  void PlaceStillCarrier(double t);
  MovingBase::Frame CarrierAt(double t);  // by the chain that moves it
  void MoveCarrier(double t);
  small::V3 BaseAcceleration(double t) const;
  void AskForForces(const small::V3& base, const RegionState& state);
  RegionState StateAt(double t, const RegionLayout& layout, const double* positions,
                      const double* velocities) const;
  void AddRules(const RegionState& state, double* x);
  bool sees_world() const {
    return contacts_.is_possible() && model_.coupling == RootCoupling::kFlight;
  }
  bool has_any_rows() const { return rows_.any() || contacts_.any_closed(); }
  void MeasureRows(const RegionState& state);
  void AddToRow(const RegionLayout& layout, const ConstraintRow& row, const small::V3& n,
                Eigen::Ref<VecX> column) const;
  void AssembleRows(const RegionLayout& layout);
  MatX AnswerRows(const RegionLayout& layout);
  VecX AnswerOfRows(const RegionLayout& layout, const VecX& pushes);
  // How the figure as a whole moves, or is pushed, along n of a row; and how a ball does, and turns
  // about its centre.
  Vec3 NetOf(const ConstraintRow& row, const small::V3& n) const;
  using AtBall = Eigen::Matrix<double, 6, 1>;
  AtBall OnBall(int ball, const ConstraintRow& row, const small::V3& n) const;
  void LetBallsAnswer();
  VecX Softness() const;
  VecX SolveRows(const MatX& A, const VecX& errors) const;
  small::V3 RootAcceleration(double t, const RegionLayout& layout, const double* x) const;
  VecX RowErrors(double t, const RegionLayout& layout, const double* x);
  small::V3 AccelerationAt(int node, const small::V3& r, const small::V3& root) const;
  void KeepTogether(const RegionState& state, double* x);
  bool is_any_locked() const { return layout_.num_dofs() < num_hinges(); }
  void YieldAsIfFree(double t, const double* y);
  void Yield(const RegionLayout& layout);
  VecX LeaveClosedRows();
  double LowerFloors(const VecX& gaps, bool only_looked_at);
  void AssembleHingeRows(const RegionState& state);
  enum class RowsOf { kAll, kConstraints, kContacts };
  void AddRowForces(RowsOf of);
  double PowerOnNodes(const std::vector<small::V3>& v) const;
  double PowerOfRows(RowsOf of, const std::vector<small::V3>& v);
  void PlaceBalls(const small::V3& p_root);
  void AccelerateBalls();
  void DeriveOuter(const double* y, double* dy);
  void AddEnergyOfBalls(EnergyFlow* flow) const;
  void AddRule(const ForceLaw& rule, const RegionState& state);
  void AnswerRule(const RegionLayout& layout);
  Mat3 AnswerOfBodies(const RegionLayout& layout, Vec3* answer);
  void Accelerate(const RegionState& state, const VecX& x);
  small::V3 RootVelocity(double t, std::vector<small::V3>* velocity) const;
  small::V3 RootPosition(double t) const;
  void PlaceNodes(double t);
  void SumForces();
  double PowerOf(const ForceLaw& law, const RegionState& state, const std::vector<small::V3>& v);
  double PowerInJoints(const std::vector<small::V3>& v, double* keyed);
  double PowerWithout(const ForceLaw& rule, const RegionState& state,
                      const std::vector<small::V3>& v);
  double PowerWithoutRules(const RegionState& state, const std::vector<small::V3>& v);
  void AddStoredEnergy(double t, const std::vector<small::V3>& v, EnergyFlow* flow) const;

  RegionModel model_;
  RegionLayout layout_, hinge_layout_;
  NodeKinematics kinematics_;
  DenseEquations dense_;
  TreeEquations tree_;
  bool by_bodies_ = false;       // solved last, not assembled the dense way
  bool assembled_some_ = false;  // and not all, last
  std::shared_ptr<const MovingBase> moving_base_;
  int first_moved_ = 0;  // the nodes before it are there only to move the moving base
  bool is_carrier_still_ = false;
  ForceLaws laws_;
  // Laws that give forces, that act from outside, that are rules.
  bool has_forces_ = false, has_outer_ = false, has_rules_ = false, has_kinks_ = false;
  bool has_springs_ = false;
  bool has_other_kinks_ = false;  // kinks of other laws than springs
  // The rows of constraints: J by dof, and what else gives way to them; the same by hinge.
  ConstraintRows rows_;
  ContactSet contacts_;
  FrozenForces frozen_;
  bool has_rows_ = false, adds_rows_ = false, contacts_by_tree_ = false;
  bool has_weightless_ = false;  // some free joint moves no mass
  // Of rows: what they measure, and what they push if contacts slide, else the same; half of what
  // the pushes do, R^-1 P^T. By bodies halves of the former too.
  MatX J_, P_, half_answer_, G_;
  bool any_slides_ = false;
  RowYield yield_;
  double least_yield_ = kBlocked;
  VecX row_forces_;
  LimitRows hinge_rows_, hinge_row_rates_;
  OuterLayout outer_layout_;
  OuterMotion outer_;
  VecX falls_;  // its accelerations
  std::vector<NodePlace> places_;
  std::vector<small::V3> velocities_;  // of the nodes' origins, relative to the root
  int most_dense_ = 64;
  double gravity_;
  const DrivenMotion* driven_ = nullptr;
  VecX added_;                                      // by a rule, by dof
  std::vector<small::V3> answer_alpha_, answer_a_;  // scratch, by node
  long evaluations_ = 0;
  double num_assembled_ = 0.0;  // of them by AssembleHinges
  Work other_work_;
};

}  // namespace hazumi
