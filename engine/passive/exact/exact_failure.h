#pragma once

namespace hazumi {

// Why a motion cannot be solved further.
struct ExactFailure {
  int hinge;  // free hinge
  enum class Cause { kStepTooSmall, kTooMuchWork, kEndsApart, kNoHold } cause;
  double gap = 0.0;     // kEndsApart: that constraints cannot close together [m, rad]
  int constraint = -1;  // kNoHold: of the island's, that has no hold any more
};

}  // namespace hazumi
