#include "engine/region/exact/release_search.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace hazumi {

ReleaseSearch::ReleaseSearch(const RegionDynamics* dynamics, ExactStep* step, ActiveLimits* limits)
    : dynamics_(dynamics),
      step_(step),
      limits_(limits),
      sample_(step->now()),
      later_{0.0, step->now()} {
  poles_.reserve(dynamics->layout().nodes().size());
}

void ReleaseSearch::Begin() {
  has_later_ = false;
  allowed_ = 0.0;
  pull_before_ = limits_->StrongestPull();
  if (!limits_->is_touching() || !limits_->any()) return;
  // Limits and contacts that hold the same in more ways than one share it otherwise here.
  const double pull = limits_->PullAt(step_->time(), step_->now());
  if (pull > 0.0) allowed_ = 2.0 * pull;
  pull_before_ = pull - allowed_;
}

// The strongest pull that a limit would have to give at t [N m].
double ReleaseSearch::Pull(double t) {
  step_->Sample(t, &sample_, Gaps::kLeft);
  return limits_->PullAt(t, sample_) - allowed_;
}

// Returns Pull, or 0 for a pull that is rounding.
double ReleaseSearch::FeltPull(double t) {
  const double pull = Pull(t);
  return pull > 0.0 && limits_->PullsByRounding() ? 0.0 : pull;
}

bool ReleaseSearch::Find() {
  const double a = step_->start_time(), b = step_->time();
  const double fa = std::min(pull_before_, 0.0), fb = FeltPull(b);
  pull_before_ = fb;
  const std::optional<double> t = FirstPull(a, fa, b, fb);
  if (!t) return false;
  if (limits_->needs_later()) LookLater(*t);
  step_->EndAt(*t);
  return true;
}

void ReleaseSearch::Cut() {
  has_later_ = false;
  pull_before_ = FeltPull(step_->time());
}

// About a pole the pull of an outer hinge changes the faster the nearer it is: looks crowd there.
std::optional<double> ReleaseSearch::FirstPull(double a, double fa, double b, double fb) {
  constexpr double kNearer = 0.25, kNearest = 1e-8;  // share of the way to the next look; [s]
  const auto find_until = [&](double t) {
    const double f = FeltPull(t);
    const std::optional<double> pull = FindPull(a, fa, t, f, 2);
    a = t;
    fa = f;
    return pull;
  };
  for (const double pole : FindPoles()) {
    for (double d = kNearer * (pole - a); d > kNearest; d *= kNearer) {
      if (const auto pull = find_until(pole - d)) return pull;
    }
    if (pole + kNearest <= a || pole + kNearest >= b) continue;
    a = pole + kNearest;  // at the pole itself the pull is not defined
    fa = FeltPull(a);
    if (fa > 0.0) return a;
    for (double d = kNearest / kNearer; d < b - pole; d /= kNearer) {
      if (const auto pull = find_until(pole + d)) return pull;
    }
  }
  return FindPull(a, fa, b, fb, 4);
}

// Times in the step at which a ball joint with an outer hinge at its limit is nearest to a pole
// [s].
const std::vector<double>& ReleaseSearch::FindPoles() {
  poles_.clear();
  if (!dynamics_->mode().contacts.rules().looks_about_poles) return poles_;
  const RegionLayout& layout = dynamics_->layout();
  for (int node = 0; node < static_cast<int>(layout.nodes().size()); ++node) {
    const RegionLayout::Node& joint = layout.node(node);
    const HingeTriple* const ball = layout.unlocked_triple(node);
    if (!ball || joint.locked[1] || !(joint.locked[0] || joint.locked[2])) continue;
    const auto recedes = [&](const HingeState& at) {
      return -ball->Approach(at.q.segment<3>(joint.first_hinge),
                             at.qd.segment<3>(joint.first_hinge));
    };
    const Bracket ends = {step_->start_time(), recedes(step_->start()), step_->time(),
                          recedes(step_->now())};
    if (ends.fa >= 0.0 || ends.fb <= 0.0) continue;
    poles_.push_back(Narrow(ends, kSameTime, [&](double t) {
                       step_->Sample(t, &sample_);
                       return recedes(sample_);
                     }).a);
  }
  std::sort(poles_.begin(), poles_.end());
  return poles_;
}

// The first time between a and b at which a limit would have to pull: looked for in the middle, at
// the end and at the top of the parabola through what is found there and at a; then in both halves,
// unless the parabola is good enough to tell that there is nothing.
std::optional<double> ReleaseSearch::FindPull(double a, double fa, double b, double fb,
                                              int halvings) {
  const double m = 0.5 * (a + b), fm = FeltPull(m);
  if (fm > 0.0) return ReleaseTime(a, fa, m, fm);
  const double bend = fa - 2.0 * fm + fb;
  const double s = bend < 0.0 ? std::clamp(0.25 * (fa - fb) / bend, -0.5, 0.5) : 0.0;
  if (s != 0.0 && std::abs(s) < 0.5) {
    const double top = m + s * (b - a), f = FeltPull(top);
    if (f > 0.0) return s < 0.0 ? ReleaseTime(a, fa, top, f) : ReleaseTime(m, fm, top, f);
  }
  if (halvings > 0 && !StaysBelow(a, fa, fm, b, fb)) {
    const std::optional<double> first = FindPull(a, fa, m, fm, halvings - 1);
    return first ? first : FindPull(m, fm, b, fb, halvings - 1);
  }
  if (fb > 0.0) return ReleaseTime(m, fm, b, fb);
  return std::nullopt;
}

// Whether limits surely need not pull between a and b: the parabola through both ends and the
// middle is below zero by several times what it is off by at a quarter of the way.
bool ReleaseSearch::StaysBelow(double a, double fa, double fm, double b, double fb) {
  const double quarter = 0.375 * fa + 0.75 * fm - 0.125 * fb;
  const double off = std::abs(Pull(0.75 * a + 0.25 * b) - quarter);
  return std::max({fa, fm, fb}) + 4.0 * off < 0.0;
}

// Which limit lets go at t is told from a moment later: limits of a ball joint's outer hinges let
// go at its poles, where the hinges line up and it cannot be told.
void ReleaseSearch::LookLater(double t) {
  later_.time = t;
  for (double later = 1e-6; later_.time < step_->time(); later *= 10.0) {
    later_.time = std::min(t + later, step_->time());
    step_->Sample(later_.time, &later_.state);
    if (!limits_->WouldHoldAll(later_)) break;
  }
  has_later_ = later_.time > t;
}

// When a limit starts to have to pull: not at a, but at b. What is late by t leaves an error of the
// order of t^3, but of t at the pole of a ball joint.
double ReleaseSearch::ReleaseTime(double a, double fa, double b, double fb) {
  const double early_enough = std::clamp(0.04 * step_->tolerance(), 1e-12, 1e-6);  // [s]
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
