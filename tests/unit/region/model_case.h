#pragma once

#include "engine/region/region_dynamics.h"
#include "engine/region/region_system.h"
#include "tests/support/sample.h"

namespace hazumi::test {

// Values, rates and accelerations of the root's hinges about z, y and x for a moving root, whose
// own angles are about x, y and z.
struct RootHinges {
  Vec3 angle, rate, acceleration;
};
RootHinges HingesOf(const MovingRoot& root);

// A polynomial of degree 2 to 5 with this value, rate and acceleration at t.
DrivenCurve CurveThrough(double t, double value, double rate, double acceleration, Random* random);

// A sample at a time t at which some joints are free, some driven by polynomials, some constant;
// the root's orientation is free, driven or constant.
struct ModelCase {
  ModelCase(uint64_t seed, RootCoupling coupling, bool is_root_free);

  // What the whole-figure equations want. Not a number where they must not look.
  PassiveState State() const;
  // The region models, with their curves set. `friction` by Coordinate.
  std::vector<RegionDynamics> Models(const VecX* friction = nullptr) const;
  VecX FreeRows(const VecX& mujoco_coordinates) const;

  static constexpr double kGravity = 9.81;

  Sample sample;
  double t;
  ModelRequest request;
  std::vector<JointIndex> free;
  DrivenMotion driven;
  VecX q, qd;  // by Coordinate, the root's included

 private:
  void ChooseRoles(bool is_root_free);
  void SetCurves();
};

// Entries of `all` (by Coordinate) that go with the free hinges.
VecX Gather(const RegionDynamics& dynamics, const VecX& all);

// Accelerations of the free hinges by the equations in hinge coordinates.
VecX HingeAccelerations(RegionDynamics* dynamics, double t, const VecX& q, const VecX& qd);

// Derivatives of a state's velocities (ball joints: angular, in the body's frame) by the equations
// that are integrated.
VecX VelocityDerivatives(RegionDynamics* dynamics, double t, const VecX& q, const VecX& qd);

// The same from accelerations of the hinges, by the kinematics of hinges alone.
VecX MapToBalls(const RegionModel& model, const VecX& q, const VecX& qd, const VecX& qdd);

}  // namespace hazumi::test
