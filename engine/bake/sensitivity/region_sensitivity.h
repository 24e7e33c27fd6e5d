#pragma once

#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/region/region_model.h"
#include "engine/region/sensitivity/sensitivity_solver.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Derivatives of a region's motion with respect to the state in which it begins.
struct RegionSensitivity {
  // The n free hinges of the region, ascending: those that friction 0 or fixed limits keep still
  // are left out; the root's follow the joints'.
  std::vector<Coordinate> hinges;
  struct AtFrame {
    int frame = 0;
    VecX q, qd;  // by `hinges`, at the frame, before what happens there [rad, rad/s]
    // 2 n x 2 n: derivatives of the angles, then the rates, there, by column with respect to the
    // angles, then the rates, on the region's first frame. What drives take from the pose on that
    // frame (Drive::frequency, SpringTarget::kStart) is a constant.
    MatX D;
  };
  std::vector<AtFrame> frames;

  struct Event {
    double time = 0.0;  // since frame 0 [s]
    LimitEvent kind = LimitEvent::kNone;
    Coordinate hinge = 0;
    double rate = 0.0;  // kHit: with which the limit was hit [rad/s]
  };
  std::vector<Event> events;  // in order of time
  // Times, by column of D, from which on the derivative is that of one side: several limits were
  // hit at once, or a hinge began at its limit; infinity: never [s].
  std::vector<double> one_sided_from;
};

struct RegionSensitivityOptions {
  SensitivitySolver::Tolerance tolerance;
  int threads = 0;  // as BakeOptions
};

// Derivatives of the motion of an exact region, by index of Animation::regions, at frames after its
// first one, ascending, up to its last one. [METHOD 3.7] Fails (ErrorCode::kSemantics) where they
// do not exist or are not covered: placements by gravity, contacts, constraints, forces from
// outside, pins that stop a moving root, holds of limbs that the region carries, hinges that are
// outside their limits, other regions whose joints feel this one's.
Result<RegionSensitivity> DeriveRegion(const Animation& animation, int region,
                                       const std::vector<int>& frames,
                                       const RegionSensitivityOptions& options = {});

}  // namespace hazumi
