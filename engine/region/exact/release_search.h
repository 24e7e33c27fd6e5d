#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/active_limits.h"
#include "engine/region/exact/exact_step.h"

namespace hazumi {

// Where in a step a limit would have to pull to hold its hinge: there it lets go. [METHOD 3.4]
class ReleaseSearch {
 public:
  // All must outlive it.
  ReleaseSearch(const RegionDynamics* dynamics, ExactStep* step, ActiveLimits* limits);

  // The limits have changed where the next step starts.
  void Begin();
  // Ends the step at the first time at which a limit would have to pull. False if there is none.
  bool Find();
  // The step was cut at its present end.
  void Cut();
  // After that, until Begin: a moment later, from which it is told what is held. Else null.
  const HingeMoment* later() const { return has_later_ ? &later_ : nullptr; }

 private:
  double Pull(double t);
  double FeltPull(double t);
  std::optional<double> FirstPull(double a, double fa, double b, double fb);
  const std::vector<double>& FindPoles();
  std::optional<double> FindPull(double a, double fa, double b, double fb, int halvings);
  bool StaysBelow(double a, double fa, double fm, double b, double fb);
  double ReleaseTime(double a, double fa, double b, double fb);
  void LookLater(double t);

  const RegionDynamics* dynamics_;
  ExactStep* step_;
  ActiveLimits* limits_;
  double allowed_ = 0.0;      // pull that does not count [N m]
  double pull_before_ = 0.0;  // strongest pull at the start of the step [N m]
  HingeState sample_;
  std::vector<double> poles_;  // found in the step [s]
  HingeMoment later_;
  bool has_later_ = false;
};

}  // namespace hazumi
