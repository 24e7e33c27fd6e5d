// Where in a step a stop would have to pull to hold its hinge: there it lets go.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/passive/exact_solver.h"

namespace hazumi {

// The strongest pull that a stop would have to give at t to hold its hinge [N m].
double ExactSolver::Pull(double t) {
  Sample(t, &sample_q_, &sample_qd_);
  stops_.Hold(t, sample_q_, sample_qd_, locked_);
  return StrongestPull();
}

double ExactSolver::StrongestPull() const {
  double most = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < locked_.size(); ++i) {
    if (locked_[i] && !fixed_[i]) most = std::max(most, side_[i] * stops_.T()[i]);
  }
  return most;
}

// The first time in the step at which a stop would have to pull.
std::optional<double> ExactSolver::FindRelease() {
  const double a = step_.start_time(), b = time_;
  const double fa = std::min(pull_before_, 0.0), fb = Pull(b);
  pull_before_ = fb;
  return FindPull(a, fa, b, fb, 4);
}

// The same between a and b: looked for in the middle, at the end and at the top of the parabola
// through what is found there and at a; then in both halves, unless the parabola is good enough to
// tell that there is nothing.
std::optional<double> ExactSolver::FindPull(double a, double fa, double b, double fb,
                                            int halvings) {
  const double m = 0.5 * (a + b), fm = Pull(m);
  if (fm > 0.0) return ReleaseTime(a, fa, m, fm);
  const double bend = fa - 2.0 * fm + fb;
  const double s = bend < 0.0 ? std::clamp(0.25 * (fa - fb) / bend, -0.5, 0.5) : 0.0;
  if (s != 0.0 && std::abs(s) < 0.5) {
    const double top = m + s * (b - a), f = Pull(top);
    if (f > 0.0) return s < 0.0 ? ReleaseTime(a, fa, top, f) : ReleaseTime(m, fm, top, f);
  }
  if (halvings > 0 && !StaysBelow(a, fa, fm, b, fb)) {
    const std::optional<double> first = FindPull(a, fa, m, fm, halvings - 1);
    return first ? first : FindPull(m, fm, b, fb, halvings - 1);
  }
  if (fb > 0.0) return ReleaseTime(m, fm, b, fb);
  return std::nullopt;
}

// Whether stops surely need not pull between a and b: the parabola through both ends and the middle
// is below zero by several times what it is off by at a quarter of the way.
bool ExactSolver::StaysBelow(double a, double fa, double fm, double b, double fb) {
  const double quarter = 0.375 * fa + 0.75 * fm - 0.125 * fb;
  const double off = std::abs(Pull(0.75 * a + 0.25 * b) - quarter);
  return std::max({fa, fm, fb}) + 4.0 * off < 0.0;
}

// A stop lets go at t. Which one is told from a moment later: stops of a ball joint's outer hinges
// let go at its poles, where the hinges line up and it cannot be told.
void ExactSolver::EndStepAtRelease(double t) {
  after_release_ = t;
  std::vector<char>& held = held_after_;
  for (double later = 1e-6; after_release_ < time_; later *= 10.0) {
    after_release_ = std::min(t + later, time_);
    Sample(after_release_, &after_q_, &after_qd_);
    for (size_t i = 0; i < side_.size(); ++i) side_[i] = locked_[i] ? side_[i] : 0;
    stops_.Rest(after_release_, after_q_, after_qd_, side_, fixed_, &held);
    if (held != locked_) break;
  }
  Sample(t, &sample_q_, &sample_qd_);
  q_ = sample_q_;
  qd_ = sample_qd_;
  anchor_ = dynamics_->anchor();
  time_ = t;
  has_event_ = true;
  is_cut_ = false;
}

// When a stop starts to have to pull: not at a, but at b. What is late by t leaves an error of the
// order of t^3, but of t at the pole of a ball joint.
double ExactSolver::ReleaseTime(double a, double fa, double b, double fb) {
  const double early_enough = std::clamp(0.04 * tolerance_, 10.0 * kSameTime, 1e-6);  // [s]
  while (b - a > early_enough) {
    const double secant = fb > fa ? (a * fb - b * fa) / (fb - fa) : 0.5 * (a + b);
    const double margin = 0.05 * (b - a);
    const double t = std::clamp(secant, a + margin, b - margin);
    const double f = Pull(t);
    (f > 0.0 ? b : a) = t;
    (f > 0.0 ? fb : fa) = f;
  }
  return b;
}

}  // namespace hazumi
