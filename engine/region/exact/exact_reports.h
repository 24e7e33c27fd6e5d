#pragma once

// Reports of an exact solution: an instant of it, and why it cannot go on.

#include <vector>

#include "engine/region/contact/contact_push.h"
#include "engine/region/forces/force_law.h"
#include "engine/spatial/wrench.h"

namespace hazumi {

// Force of a constraint, and its magnitude [N].
struct ConstraintPush {
  double size = 0.0;
  Wrench on_a;  // at the point of its end a, world axes; the opposite acts on b
};

// Accelerations of an island at an instant, and what acts on it.
struct InstantReport {
  VecX qd, qdd;              // of the free hinges [rad/s, rad/s^2]; 0 where a limit holds one
  Vec3 fall = Vec3::Zero();  // of the centre of mass, where it is part of the state [m/s^2]
  std::vector<ConstraintPush> constraints;  // by index of the island's constraints
  std::vector<ContactPush> contacts;
  std::vector<SpentDrive> spent;
};

// Why a motion cannot be solved further.
struct ExactFailure {
  int hinge;  // free hinge
  enum class Cause { kStepTooSmall, kTooMuchWork, kEndsApart, kNoHold } cause;
  double gap = 0.0;     // kEndsApart: that constraints cannot close together [m, rad]
  int constraint = -1;  // kNoHold: of the island's, that has no hold any more
};

}  // namespace hazumi
