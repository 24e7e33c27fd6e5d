#include "engine/passive/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hazumi {

namespace {

constexpr double kLeastStep = 1e-12;  // [s]
constexpr double kSafety = 0.9;       // of steps, so that few are rejected
// From the first start on, so that what cannot be solved ends within ten seconds.
constexpr double kMostWork = 1e6, kMostWorkPerSecond = 1e6;  // in evaluations
constexpr double kChatterWindow = 1.0 / 30.0;                // [s]
constexpr int kChatter = 24;  // events in the window before stops become sticky

}  // namespace

ExactSolver::ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper)
    : dynamics_(dynamics), lower_(std::move(lower)), upper_(std::move(upper)), stops_(dynamics) {
  const int n = dynamics->num_hinges();
  lower_now_ = lower_;
  upper_now_ = upper_;
  for (VecX* x : {&q_, &qd_, &q_start_, &qd_start_, &sample_q_, &sample_qd_, &look_q_, &look_qd_,
                  &before_q_, &before_qd_, &after_q_, &after_qd_})
    x->setZero(n);
  // The longest state: all in balls, and a fall.
  for (VecX* x : {&y_, &scale_}) x->resize(2 * n + n / 3 + 6);
  side_.assign(n, 0);
  locked_.assign(n, 0);
  held_after_.assign(n, 0);
  sticks_.assign(n, 0);
  fixed_.assign(n, 0);
  last_hit_.assign(n, -1);
  for (int i = 0; i < n; ++i) {
    any_limits_ |= std::isfinite(lower_[i]) || std::isfinite(upper_[i]);
  }
  recent_.reserve(256);
  suspects_.reserve(n);
}

void ExactSolver::Start(double t, const VecX& q, const VecX& qd, const PointMotion& anchor) {
  time_ = t;
  if (steps_ == 0) first_start_ = t;
  q_ = q;
  qd_ = qd;
  anchor_ = anchor;
  lower_now_ = lower_.cwiseMin(q);
  upper_now_ = upper_.cwiseMax(q);
  touch_ = kTouch;
  has_event_ = false;
  after_release_ = -std::numeric_limits<double>::infinity();
  recent_.clear();
  next_h_ = 0.0;
  std::fill(locked_.begin(), locked_.end(), 0);
  ResolveStops(Vec3::Zero());
  Relock();
}

void ExactSolver::Restart() {
  has_event_ = false;
  ResolveStops(Vec3::Zero());
  Relock();
}

void ExactSolver::FeelPin(const Vec3& v_pin) {
  has_event_ = false;
  ResolveStops(v_pin);
  Relock();
}

// Which stops hold which hinges from time_ on, after the impact of those that go out and of a pin
// that was stopped.
void ExactSolver::ResolveStops(const Vec3& v_pin) {
  dynamics_->SetAnchor(anchor_);
  const bool with_impulse = !v_pin.isZero(0.0);
  const int outward = any_limits_ ? FindSides(with_impulse) : 0;
  if (with_impulse || outward > 0) Collide(v_pin);
  Settle();
}

// The hinges at a stop; those on their way in only where an impulse or another hinge's impact may
// send them out. Returns how many are not at rest there.
int ExactSolver::FindSides(bool with_impulse) {
  int moving = 0;
  bool is_struck = with_impulse;
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    side_[i] = 0;
    if (q_[i] >= upper_now_[i] - touch_) side_[i] = 1;
    if (q_[i] <= lower_now_[i] + touch_) side_[i] = -1;
    fixed_[i] = upper_now_[i] - lower_now_[i] <= 2.0 * kTouch;
    if (fixed_[i]) side_[i] = 1;
    is_struck |= fixed_[i] ? qd_[i] != 0.0 : side_[i] * qd_[i] > touch_rate();
  }
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    if (fixed_[i]) {
      sticks_[i] = 1;
      moving += qd_[i] != 0.0;
      continue;
    }
    const double out = side_[i] * qd_[i];
    if (out < -touch_rate() && !is_struck) side_[i] = 0;
    sticks_[i] = side_[i] != 0 && out < 0.0 && out >= -touch_rate();
    moving += side_[i] != 0 && out != 0.0;
    if (out > touch_rate()) AddHit(i);
  }
  return moving;
}

void ExactSolver::Collide(const Vec3& v_pin) {
  stops_.Impact(time_, q_, v_pin, side_, sticks_, &qd_);
  for (size_t i = 0; i < side_.size(); ++i) {
    if (side_[i] * qd_[i] < -touch_rate()) side_[i] = 0;  // pushed off
  }
}

// Locks the hinges at rest that their stops go on holding.
void ExactSolver::Settle() {
  any_locked_ = false;
  std::fill(locked_.begin(), locked_.end(), 0);
  bool any = false;
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    if (side_[i] == 0) continue;
    any = true;
    qd_[i] = 0.0;
    q_[i] = side_[i] > 0 ? upper_now_[i] : lower_now_[i];
  }
  if (!any) return;
  const bool lets_go = after_release_ > time_;
  stops_.Rest(lets_go ? after_release_ : time_, lets_go ? after_q_ : q_, lets_go ? after_qd_ : qd_,
              side_, fixed_, &locked_);
  pull_before_ = StrongestPull();
  any_locked_ = std::find(locked_.begin(), locked_.end(), 1) != locked_.end();
}

// Lays the state out anew after locks or curves changed.
void ExactSolver::Relock() {
  follows_event_ = true;
  after_release_ = -std::numeric_limits<double>::infinity();
  is_cut_ = false;
  dynamics_->SetLocked(locked_, q_);
  dynamics_->layout().Pack(q_, qd_, y_.data());
  dynamics_->SetAnchor(anchor_);
  dynamics_->PackAnchor(y_.data());
  step_.Resize(dynamics_->state_size());
  SetScale();
  const auto field = [this](double t, const double* y, double* dy) {
    dynamics_->Derivative(t, y, dy);
  };
  step_.Start(time_, y_.data(), field);
  last_error_ = 1.0;
}

void ExactSolver::SetScale() {
  const int positions = dynamics_->layout().num_positions();
  const int size = dynamics_->layout().state_size();
  for (int i = 0; i < size; ++i) {
    scale_[i] = i < positions ? (dynamics_->layout().is_quaternion(i) ? 0.5 : 1.0) * tolerance_
                              : kRateScale * tolerance_;
  }
  // Of a fall: a radian at the end of a metre is a metre.
  for (int i = size; i < dynamics_->state_size(); ++i) {
    scale_[i] = (i < size + 3 ? 1.0 : kRateScale) * tolerance_;
  }
}

// From how fast the motion is: a step of order 8 covers about this much of a turn.
double ExactSolver::FirstStep(double end) const {
  const double* dy = step_.end_derivative();
  double speed = 1.0;
  const int positions = dynamics_->layout().num_positions();
  for (int i = 0; i < dynamics_->layout().state_size(); ++i) {
    const double size = std::abs(dy[i]);
    speed = std::max(speed, i < positions ? size : std::sqrt(size));
  }
  return std::min(end - time_, 1.5 * std::pow(tolerance_, 0.125) / speed);
}

std::optional<ExactFailure> ExactSolver::Advance(double end) {
  if (dynamics_->work() > kMostWork + kMostWorkPerSecond * (time_ - first_start_)) {
    return Failure(ExactFailure::Cause::kTooManyEvaluations);
  }
  if (has_event_) MakeEventHappen();
  if (is_cut_) GoOnFromCut();
  q_start_ = q_;
  qd_start_ = qd_;
  std::optional<ExactFailure> failure;
  if (!Step(end, &failure)) return failure;
  ++steps_;
  time_ = step_.end_time();
  if (std::abs(time_ - end) < kSameTime) time_ = end;
  sample_q_ = q_;
  TakeState(step_.y());
  if (!any_limits_) return std::nullopt;
  has_event_ = FindHit();
  const std::optional<double> release = any_locked_ ? FindRelease() : std::nullopt;
  if (release) EndStepAtRelease(*release);
  follows_event_ = false;
  TightenStops();
  return std::nullopt;
}

// A stop was hit or lets go at time_. Where that happens again and again stops become sticky, so
// that joints that press on their stops in turn come to rest instead of chattering.
void ExactSolver::MakeEventHappen() {
  has_event_ = false;
  while (!recent_.empty() && recent_.front() < time_ - kChatterWindow) {
    recent_.erase(recent_.begin());
  }
  recent_.push_back(time_);
  const int excess = std::max(0, static_cast<int>(recent_.size()) - kChatter);
  touch_ = kTouch * std::pow(2.0, std::min(excess, 20));
  WidenStops();
  ResolveStops(Vec3::Zero());
  Relock();
}

// What the step may grow by. Errors that rise from step to step go on rising: proportional and
// integral control [Hairer, Wanner 1996, IV.2] sees that and saves most rejections, and so does
// slow growth, unless there is next to no error.
double ExactSolver::Growth(double error) const {
  constexpr double kNone = 1e-5;
  const double trend = std::pow(std::max(last_error_, 1e-4), 0.04);
  const double grow = kSafety * std::pow(std::max(error, 1e-10), -0.1) * trend;
  return std::clamp(grow, 0.333, error < kNone ? 6.0 : 1.5);
}

ExactFailure ExactSolver::Failure(ExactFailure::Cause cause) const {
  return {dynamics_->layout().HingeOf(step_.worst_component()), cause};
}

// One accepted step. False with `failure` set if there is none.
bool ExactSolver::Step(double end, std::optional<ExactFailure>* failure) {
  const auto field = [this](double t, const double* y, double* dy) {
    dynamics_->Derivative(t, y, dy);
  };
  double h = std::min(longest_step_, next_h_ > 0.0 ? next_h_ : FirstStep(end));
  for (;;) {
    const double rest = end - time_;
    // Equal steps to the end rather than a tiny last one.
    const double use = rest / std::max(1.0, std::ceil(rest / h * (1.0 - 1e-9)));
    const double error = step_.Try(use, scale_.data(), field);
    if (error <= 1.0) {
      step_.Accept(field);
      const double grow = Growth(error);
      next_h_ = std::max(h * 0.5, use * grow);
      if (use < h) next_h_ = std::max(next_h_, std::min(h, use * grow));
      last_error_ = error;
      return true;
    }
    const double grow = kSafety * std::pow(error, -0.125);
    h = use * (std::isfinite(error) ? std::clamp(grow, 0.1, 0.9) : 0.1);
    if (h >= kLeastStep) continue;
    *failure = Failure(ExactFailure::Cause::kStepTooSmall);
    return false;
  }
}

// q_ is near by.
void ExactSolver::TakeState(const double* y) {
  dynamics_->layout().Unpack(y, lower_now_, upper_now_, &q_, &qd_);
  dynamics_->SetAnchorOf(y);
  anchor_ = dynamics_->anchor();
}

void ExactSolver::MakeDense() {
  step_.MakeDense(
      [this](double t, const double* y, double* dy) { dynamics_->Derivative(t, y, dy); });
}

void ExactSolver::Sample(double t, VecX* q, VecX* qd) {
  MakeDense();
  step_.At(t, y_.data());
  const double length = time_ - step_.start_time();
  const double s = length > 0.0 ? (t - step_.start_time()) / length : 0.0;
  *q = s < 0.5 ? q_start_ : q_;  // nearby, to pick the branch
  qd->resize(q->size());
  dynamics_->layout().Unpack(y_.data(), lower_now_, upper_now_, q, qd);
  dynamics_->SetAnchorOf(y_.data());
}

EnergyFlow ExactSolver::Energy(double t) {
  MakeDense();
  step_.At(t, y_.data());
  return dynamics_->MeasureEnergy(t, y_.data());
}

// Where a ball joint passes a pole its outer hinges' angles jump, perhaps beyond their stops: such
// a hinge has a stop where it is until it has come inside.
void ExactSolver::WidenStops() {
  constexpr double kJump = 10.0 * kTouch;
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    if (Outside(i, q_) <= kJump) continue;
    lower_now_[i] = std::min(lower_now_[i], q_[i]);
    upper_now_[i] = std::max(upper_now_[i], q_[i]);
  }
}

// A hinge that started outside has its own stop from when it is inside.
void ExactSolver::TightenStops() {
  lower_now_ = lower_.cwiseMin(lower_now_.cwiseMax(q_));
  upper_now_ = upper_.cwiseMax(upper_now_.cwiseMin(q_));
}

// How far beyond its stops a hinge is [rad]; negative inside.
double ExactSolver::Outside(int hinge, const VecX& q) const {
  return std::max(lower_now_[hinge] - q[hinge], q[hinge] - upper_now_[hinge]);
}

}  // namespace hazumi
