#pragma once

namespace hazumi {

// Why a motion cannot be solved further.
struct ExactFailure {
  int hinge;  // free hinge
  enum class Cause { kStepTooSmall, kTooManyEvaluations, kEndsApart } cause;
  double gap = 0.0;  // kEndsApart: that constraints cannot close together [m, rad]
};

}  // namespace hazumi
