#pragma once

#include <string>
#include <vector>

#include "engine/region/row_system.h"

namespace hazumi {

// Energy of the bodies of an island, and the power that flows into them. Where the root flies, as
// seen from the centre of mass, unless it may touch things; else potential energy counts from the
// height of the world's origin, or of the pin.
struct EnergyFlow {
  double kinetic = 0.0, potential = 0.0;  // [J]
  double keyed = 0.0;                     // [W], by driven joints and the motion of the moving base
  struct OfLaw {
    std::string name;
    double power;  // [W], negative where energy is lost
  };
  std::vector<OfLaw> laws;
};

// Measures the energy of an island and its flow at an instant that has been evaluated. The power of
// each law is found from what it does to the nodes, not from the others. [METHOD 8.5]
class EnergyMeter {
 public:
  // An island at the instant, with accelerations `x` of the directions. All must outlive the meter.
  struct Instant {
    const RegionModel& model;
    const RegionLaws& laws;
    const RegionMode& mode;
    const FreeBodies& bodies;
    const RowSystem& rows;
    const SolvedEquations& equations;
    const OuterMotion& outer;
    VecX x;
    bool has_rows, has_weightless;  // there are rows; joints that move no mass
  };
  // `kinematics`: of the instant; moves the whole figure there.
  EnergyMeter(const Instant& at, RegionKinematics* kinematics);

  EnergyFlow Measure();

 private:
  using Velocities = std::vector<small::V3>;  // of the nodes' origins, then of balls [m/s]

  void Accelerate(const VecX& x);
  void Load(const small::V3& base);
  void MeasureEnergy(EnergyFlow* flow) const;
  void SumForces();
  double PowerInJoints(double* keyed);
  double PowerWithout(const ForceLaw& rule);
  double PowerWithoutRules();
  double PowerOf(const ForceLaw& law);
  double PowerOfRows(RowSystem::Kind kind);
  double PowerOnNodes() const;
  bool sees_world() const {
    return at_.mode.contacts.is_possible() && at_.model.coupling == RootCoupling::kFlight;
  }

  const Instant& at_;
  RegionKinematics* kinematics_;
  RegionState state_;
  NodeKinematics* nodes_;
  Velocities v_;
};

}  // namespace hazumi
