#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/warning.h"
#include "engine/dynamics/workspace.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Watches whether constraints that have time to close a gap do so: as their law says, which limits,
// contacts and limbs that are too short keep them from [METHOD 11.3].
class Arrivals {
 public:
  explicit Arrivals(const Animation& animation) : animation_(animation) {}

  void Forget() { known_.clear(); }
  // Those of `acting` that are new begin to close the gap that there is in `motion`, others go on
  // from what there is of it, after whatever happened.
  void Begin(const std::vector<int>& acting, const FigureMotion& motion, DynamicsWorkspace* ws);
  // Warns of each constraint of `acting` whose arrival time is over and whose gap is still too
  // large. `is_free`: whether a region moves a hinge; set only if hinges alone, not the root, move
  // the ends.
  using IsFree = std::function<bool(JointIndex)>;
  std::vector<Warning> Look(const std::vector<int>& acting, const FigureMotion& motion,
                            const std::optional<IsFree>& is_free, DynamicsWorkspace* ws);
  // None if its time was over.
  std::vector<Warning> Break(int constraint, double frame);

 private:
  // How far its ends are apart and how fast that changes, seen from b: of a distance in x alone;
  // of a weld the turn too.
  struct Gap {
    Vec3 e = Vec3::Zero(), rate = Vec3::Zero();     // [m, m/s]
    Vec3 turn = Vec3::Zero(), spin = Vec3::Zero();  // [rad, rad/s]
  };
  struct Arrival {
    int constraint = 0;
    double until = 0.0;             // frame in which its time is over
    double size = 0.0, turn = 0.0;  // of the gap where it began [m, rad]
    double frame = 0.0;             // from which it goes on
    Gap gap = {};                   // there
    bool is_over = false;
  };
  // Of a figure whose positions and velocities are computed.
  Gap GapOf(const Constraint& constraint, const DynamicsWorkspace& ws) const;
  std::string LateText(const Arrival& arrival, double frame, const DynamicsWorkspace& ws) const;
  bool IsStraight(const ConstraintEnd& end, const Vec3& way, const IsFree& is_free,
                  const DynamicsWorkspace& ws) const;
  bool IsStraight(const Constraint& constraint, const IsFree& is_free,
                  const DynamicsWorkspace& ws) const;

  const Animation& animation_;
  std::vector<Arrival> known_;
};

}  // namespace hazumi
