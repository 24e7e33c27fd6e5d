#pragma once

#include "engine/figure/figure.h"
#include "engine/region/paper_step.h"
#include "tests/support/arm7_cases.h"

namespace hazumi::test {

// Every joint of a figure, for a region that is the whole of it.
std::vector<JointIndex> AllJoints(const Figure& figure);

constexpr double kRadian = 57.295779513082320877;  // in degrees

struct SwingEnd {
  PaperStepStatus status;
  VecX q, qd;  // where it ended, or where the failing step began
  int steps;   // that succeeded
};

// The whole figure left to itself on a root at rest, by the paper's step.
struct Swing {
  const Figure& figure;
  VecX q, qd, friction, lower, upper;  // friction per 1/30 s
  double gravity, step;
  int steps;

  SwingEnd Run() const;
};

SwingEnd RunArmCase(const ArmCase& arm_case, int steps_per_frame);

}  // namespace hazumi::test
