#pragma once

// Internal. Torques of a region's hinges with which the baked motion meets goals.

#include <atomic>
#include <vector>

#include "engine/base/result.h"
#include "engine/makers/aims/aim_goals.h"

namespace hazumi::makers {

struct TorqueAim {
  size_t region = 0;  // index of Animation::regions
  std::vector<AimGoal> goals;
  double most = 1.0;  // share of its strength that a hinge may use
};

struct HingeTorque {
  JointIndex hinge;
  Keys keys;  // [N m]
};

struct FoundTorques {
  std::vector<HingeTorque> torques;  // empty: the limb arrives by itself
  int bakes = 0, iterations = 0;
};

// Returns the torques that came nearest to the goals. `animation`: its region gives the hinges that
// are looked for no torques. Errors: those of the bakes without torques and with those found,
// kSemantics for a point out of reach, kInterrupted.
Result<FoundTorques> FindTorques(const TorqueAim& aim, const Animation& animation,
                                 const std::atomic<bool>* cancel);

}  // namespace hazumi::makers
