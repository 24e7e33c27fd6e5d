#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/region/driven_curve.h"
#include "engine/region/exact/exact_solver.h"
#include "engine/region/region_model.h"
#include "engine/spatial/body_motion.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// What was let go, by nothing but its inertia and gravity.
BodyMotion Falling(const BodyMotion& start, double seconds, double gravity);

// A ball that was let go and touches planes and boxes: one rigid body without a hand, moved by
// ExactSolver. It knows the same motion whichever times it is asked for, and in which order.
// [METHOD 12.6]
class ObjectFlight {
 public:
  // Starts the flight at `start` seconds. The shape is a sphere.
  ObjectFlight(const HeldObject& object, const std::vector<SceneObject>& scene, double gravity,
               double start, const BodyMotion& from,
               const SolverRules& rules = SolverRules(kSolverVersion));

  // Later than the start. What cannot be solved further stays where it is.
  BodyMotion At(double seconds);
  // From when on it stays so [s].
  const std::optional<double>& stuck_from() const { return stuck_from_; }

  double start() const { return start_; }
  const BodyMotion& from() const { return from_; }

 private:
  struct Run {
    Run(const RegionModel& model, double gravity, const ContactSpec& contacts);
    DrivenMotion nothing;
    RegionDynamics dynamics;
    ExactSolver solver;
  };
  void Begin();
  void Step();
  HingeState Sample(double seconds);
  BodyMotion MotionOf(const HingeState& state) const;
  double KineticOf(const HingeState& state) const;
  double EnergyOf(const HingeState& state) const;
  double DepthOf(const HingeState& state) const;
  double GainOfComingOut(double depth) const;
  double radius() const { return contacts_.capsules[0].radius; }

  RegionModel model_;
  ContactSpec contacts_;
  double gravity_, start_;
  BodyMotion from_;
  std::unique_ptr<Run> run_;
  HingeState last_;          // at the end of the solver's present step
  bool is_stopped_ = false;  // where that began
  std::optional<double> stuck_from_;
};

}  // namespace hazumi
