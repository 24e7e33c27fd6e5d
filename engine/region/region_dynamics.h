#pragma once

#include <memory>
#include <vector>

#include "engine/region/energy_meter.h"
#include "engine/region/equations/hinge_equations.h"
#include "engine/region/hinge_state.h"
#include "engine/region/work.h"

namespace hazumi {

// The equations of motion of an island in continuous time [METHOD 2.2]:
//   M(q) x = -b(q, v, t),   v' = x + r(q, v, t)
// with v the velocities of a RegionLayout, b what motion, gravity and the forces of all laws ask
// for, and r the accelerations of laws that are rules, as friction is. World axes; points from the
// root's origin. They are evaluated in stages, each of which takes the result of the one before:
//   RegionKinematics::Place -> RegionState        where nodes are, and how they move
//   RegionLaws::Load        -> LoadedState        with all forces
//   EquationsOfMotion       -> SolvedEquations    M and b, by matrix or by tree
//   RowSystem               -> RowResponse        forces of constraints and contacts
class RegionDynamics {
 public:
  // `gravity`: along -z [m/s^2].
  RegionDynamics(RegionModel model, ForceLaws laws, double gravity,
                 std::vector<ConstraintSpec> constraints = {}, ContactSpec contacts = {});

  const RegionModel& model() const { return *model_; }
  const RegionLaws& laws() const { return laws_; }
  const FreeBodies& bodies() const { return bodies_; }
  double gravity() const { return bodies_.gravity(); }
  const RegionLayout& layout() const { return mode_.layout; }
  const std::vector<FreeHinge>& hinges() const { return hinge_layout_.hinges(); }
  int num_hinges() const { return hinge_layout_.num_hinges(); }
  // Layout of the end of a state, after the positions and velocities of layout().
  const OuterLayout& outer_layout() const { return outer_layout_; }
  int state_size() const { return layout().state_size() + outer_layout_.size(); }

  // Everything that stays the same between two events.
  RegionMode& mode() { return mode_; }
  const RegionMode& mode() const { return mode_; }
  // The first stage. Its curves have to be set before anything is evaluated.
  RegionKinematics& kinematics() { return kinematics_; }
  // Sets curves, which must outlive their use and are smooth from `start` to `end` [s].
  void SetDriven(const DrivenMotion* driven, double start, double end);
  // Sets the largest number of free hinges of an island on a pin that is solved by matrix.
  void SetMostDense(int hinges) { most_dense_ = hinges; }

  // Whether anything acts besides gravity and the moving base.
  bool is_pushed() const { return laws_.any_forces() || has_rows_; }
  // Whether forces from outside move the centre of mass of a figure in flight: it is part of the
  // state then.
  bool is_pushed_in_flight() const {
    return is_seen_in_world() && model_->coupling == RootCoupling::kFlight;
  }
  // Whether limits are solved for some hinges alone: in large islands that are solved by tree.
  bool is_large() const;
  // Whether contacts and limits of the island are solved together by tree: in large islands with
  // contacts with fixed obstacles only, in time-stepping mode. [METHOD 12.10]
  bool solves_contacts_by_tree() const { return contacts_by_tree_; }
  // Whether springs are implicit in time-stepping mode.
  bool has_implicit_springs() const {
    return mode_.contacts.rules().stands_on_springs && laws_.any_springs();
  }
  // Whether any force has a kink, and what changes sign there (ForceLaw).
  bool has_kinks() const { return laws_.any_kinks(!mode_.constant.holds_springs); }
  void FindKinks(const RegionState& state, std::vector<double>* kinks) const {
    laws_.FindKinks(state, !mode_.constant.holds_springs, kinks);
  }
  double FastestRate() const;  // of all laws and constraints, as ForceLaw has it [1/s]

  HingeState NewState() const;  // zero
  void Pack(const HingeState& state, double* y) const;
  // `state` on entry: a state nearby. The limits tell the sides of ball joints (RegionLayout).
  void Unpack(const double* y, const VecX& lower, const VecX& upper, HingeState* state) const;

  // Sets dy = dy/dt at time t [s], a function of the mode, t and y. Counts as one evaluation.
  void Derivative(double t, const double* y, double* dy) {
    ++evaluations_;
    Evaluate(mode_, t, y, dy);
  }
  // The same for reports, not counted.
  SolvedEquations Evaluate(const RegionMode& mode, double t, const double* y, double* dy);
  SolvedEquations Evaluate(double t, const double* y, double* dy) {
    return Evaluate(mode_, t, y, dy);
  }
  // Rows and their forces in the latest evaluation.
  const RowSystem& rows() const { return rows_; }

  // Equations in all free hinges; of some of them in a large island; by tree where
  // solves_contacts_by_tree(). Each counts as one evaluation.
  HingeEquations AssembleHinges(double t, const HingeState& state);
  SomeHinges AssembleSome(const std::vector<int>& hinges, double t, const HingeState& state);
  HingeTree AssembleByTree(double t, const HingeState& state);

  // Places the nodes; not counted as an evaluation. Placed... returns the latest placement, which
  // was with the same arguments.
  RegionState PlaceAt(double t, const double* y);
  RegionState PlacedAt(double t, const double* y) const {
    return kinematics_.Placed(t, layout(), y, y + layout().num_positions());
  }
  RegionState PlaceHinges(double t, const HingeState& state);
  RegionState PlacedHinges(double t, const HingeState& state) const {
    return kinematics_.Placed(t, hinge_layout_, state.q.data(), state.qd.data());
  }
  // Projects a state on closed constraints and contacts, by the least change as masses count.
  // Returns the gap that is left [m, rad]. Counts as two evaluations. Where contacts have no room
  // the rest of their gaps is allowed from now on, unless it is `only_sampled`.
  double CloseGaps(double t, double* y, bool only_sampled = false);

  EnergyFlow MeasureEnergy(double t, const double* y);
  // Drives that give all they can.
  std::vector<SpentDrive> SpentDrives(double t, const HingeState& state);

  long evaluations() const { return evaluations_; }
  // Adds work of others on this island, in evaluations.
  void AddWork(const Work& evaluations) { other_work_ += evaluations; }
  // Work so far, in evaluations of accelerations.
  Work work() const;

 private:
  bool is_seen_in_world() const { return laws_.any_outer() || has_rows_; }
  EquationsMethod MethodFor(const RegionMode& mode) const;
  bool SolvesContactsByTree() const;
  void TakeOuter(const RegionMode& mode, const double* y);
  LoadedState Load(const RegionMode& mode, const RegionState& state) {
    return laws_.Load(state, mode.constant, bodies_, &kinematics_.nodes());
  }
  void FindComplianceUnlocked(const RegionMode& mode, double t, const double* y);
  double AllowWhatIsLeft(const VecX& gaps, bool only_sampled);

  std::shared_ptr<const RegionModel> model_;
  RegionLaws laws_;
  bool has_rows_;  // there are constraints or may be contacts
  RegionMode mode_;
  RegionLayout hinge_layout_;
  OuterLayout outer_layout_;
  FreeBodies bodies_;
  RegionKinematics kinematics_;
  EquationsOfMotion equations_;
  RowSystem rows_;
  OuterMotion outer_;  // in the latest evaluation
  int most_dense_ = 64;
  bool contacts_by_tree_ = false;
  bool has_weightless_ = false;  // some free joint moves no mass
  long evaluations_ = 0;
  double num_assembled_ = 0.0;  // evaluations by AssembleHinges
  Work other_work_;
};

}  // namespace hazumi
