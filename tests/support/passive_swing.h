#pragma once

// Whole figures on a root at rest, left to themselves: the two methods without a bake around them.

#include <vector>

#include "engine/figure/figure.h"
#include "engine/region/exact/exact_solver.h"

namespace hazumi::test {

// What is let go. Limits are those of the figure's joints.
struct Release {
  const Figure& figure;
  VecX q, qd;      // at the start [rad, rad/s], by JointIndex
  double seconds;  // how long
  double gravity = 9.81;
  double friction = 1.0;  // factor per 1/30 s, of every joint
};

// How it went.
struct Course {
  bool finished = false;      // up to the end, all numbers finite on the way
  double time = 0.0;          // how far it got [s]
  VecX q, qd;                 // there
  long steps = 0;             // taken
  long evaluations = 0;       // of the equations of motion
  double largest_step = 0.0;  // [s]
  // Greatest change and greatest gain at the end of any step, in units of EnergyScale.
  double energy_drift = 0.0, energy_gain = 0.0;
  double outside = 0.0;        // greatest way beyond a limit there [rad]
  std::vector<LimitHit> hits;  // kExact only
};

// `tolerance`: error of one step [rad]. Ends unfinished after `most_steps`.
Course SwingExactly(const Release& release, double tolerance, long most_steps = 10'000'000);
// In equal steps of about `step` seconds; ends unfinished where the paper's step cannot go on.
Course SwingByPaper(const Release& release, double step);

}  // namespace hazumi::test
