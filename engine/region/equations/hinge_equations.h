#pragma once

#include <vector>

#include "engine/region/equations/equations_of_motion.h"
#include "engine/region/equations/tree_impulses.h"
#include "engine/region/exact/limit_rows.h"

namespace hazumi {

// Equations of motion of an island in its free hinges, locked or not, at one instant: M x + b =
// torques. Returned by RegionDynamics::AssembleHinges, valid until it assembles again.
class HingeEquations {
 public:
  const MatX& M() const { return dense_->equations().M; }
  const VecX& b() const { return dense_->equations().b; }
  // Rows of constraints and contacts, for accelerations and for impulses; null: there are none.
  const LimitRows* for_forces() const { return for_forces_; }
  const LimitRows* for_impulses() const { return for_impulses_; }
  // Impulses on the hinges where the pin is stopped [N m s]. [METHOD 5.7]
  bool stops_pin() const { return !pin_velocity_.isZero(0.0); }
  void StopPin(VecX* impulse) const { dense_->PinImpulse(pin_velocity_, impulse); }

 private:
  friend class RegionDynamics;
  HingeEquations(const DenseEquations* dense, const Vec3& pin_velocity, const LimitRows* for_forces,
                 const LimitRows* for_impulses)
      : dense_(dense),
        pin_velocity_(pin_velocity),
        for_forces_(for_forces),
        for_impulses_(for_impulses) {}

  const DenseEquations* dense_;
  Vec3 pin_velocity_;
  const LimitRows *for_forces_, *for_impulses_;
};

// The same of some hinges of a large island, with the others following freely. Returned by
// RegionDynamics::AssembleSome, valid until it assembles again.
class SomeHinges {
 public:
  const MatX& M() const { return tree_->some().M; }
  const VecX& b() const { return tree_->some().b; }
  // Changes of the rates of all free hinges due to impulses on those hinges [N m s].
  VecX RatesOf(const VecX& impulses) const { return tree_->JumpOf(impulses); }
  // The same where the pin is stopped.
  bool stops_pin() const { return !pin_velocity_.isZero(0.0); }
  VecX RatesOfStop() const {
    return tree_->JumpOfPin(state_.layout, state_.kinematics.motion(), pin_velocity_);
  }

 private:
  friend class RegionDynamics;
  SomeHinges(TreeEquations* tree, const RegionState& state, const Vec3& pin_velocity)
      : tree_(tree), state_(state), pin_velocity_(pin_velocity) {}

  TreeEquations* tree_;
  RegionState state_;
  Vec3 pin_velocity_;
};

// A large island without matrix, for time stepping. Returned by RegionDynamics::AssembleByTree,
// valid until it assembles again. [METHOD 12.10]
class HingeTree {
 public:
  // Accelerations of the hinges without rules; those of the rows with rules.
  const VecX& x_0() const { return x_0_; }
  const VecX& of_rows() const { return of_rows_; }
  // Begins impulses in this state.
  void Begin(TreeImpulses* impulses) const {
    impulses->Begin(state_.layout, state_.kinematics.motion(), *bodies_);
  }
  // Kinetic energy for rates of the hinges, in flight relative to the centre of mass [J].
  double KineticEnergy(const VecX& qd) const;

 private:
  friend class RegionDynamics;
  HingeTree(const ArticulatedBodies* bodies, const RegionState& state, VecX x_0)
      : bodies_(bodies), state_(state), x_0_(std::move(x_0)) {}

  const ArticulatedBodies* bodies_;
  RegionState state_;
  VecX x_0_, of_rows_;
};

}  // namespace hazumi
