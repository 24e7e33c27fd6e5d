#pragma once

namespace hazumi {

// Why a motion cannot be solved further.
struct ExactFailure {
  int hinge;  // free hinge
  enum class Cause { kStepTooSmall, kTooManyEvaluations } cause;
};

}  // namespace hazumi
