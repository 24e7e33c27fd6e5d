#include "engine/passive/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hazumi {

namespace {

constexpr double kTouch = 1e-10;      // at a stop [rad]
constexpr double kLeastStep = 1e-12;  // [s]
constexpr double kSameTime = 1e-13;   // [s]
constexpr double kBeyondPole = 1e-6;  // so far from a pole its side is certain [rad]
constexpr double kSafety = 0.9;       // of steps, so that few are rejected
constexpr long kMostEvaluations = 20'000'000;
constexpr double kChatterWindow = 1.0 / 30.0;  // [s]
constexpr int kChatter = 24;                   // events in the window before stops become sticky

}  // namespace

ExactSolver::ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper)
    : dynamics_(dynamics), lower_(std::move(lower)), upper_(std::move(upper)) {
  const int n = dynamics->num_hinges();
  lower_now_ = lower_;
  upper_now_ = upper_;
  for (VecX* x : {&q_, &qd_, &q_start_, &qd_start_, &sample_q_, &sample_qd_, &look_q_, &look_qd_,
                  &before_q_, &before_qd_, &after_q_, &after_qd_})
    x->setZero(n);
  for (VecX* x : {&y_, &scale_}) x->resize(2 * n + n / 3);  // the longest state, all in balls
  side_.assign(n, 0);
  locked_.assign(n, 0);
  held_after_.assign(n, 0);
  sticks_.assign(n, 0);
  fixed_.assign(n, 0);
  stops_.Resize(n);
  blow_.setZero(n);
  for (int i = 0; i < n; ++i) {
    any_limits_ |= std::isfinite(lower_[i]) || std::isfinite(upper_[i]);
  }
  recent_.reserve(256);
  suspects_.reserve(n);
}

void ExactSolver::Start(double t, const VecX& q, const VecX& qd) {
  time_ = t;
  q_ = q;
  qd_ = qd;
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
  const bool with_blow = !v_pin.isZero(0.0);
  const int outward = any_limits_ ? FindSides(with_blow) : 0;
  if (with_blow || outward > 0) {
    dynamics_->AssembleHinges(time_, q_, qd_);
    dynamics_->PinBlow(v_pin, &blow_);
    Collide(blow_);
  }
  Settle();
}

// The hinges at a stop; those on their way in only where a blow or another hinge's impact may send
// them out. Returns how many are not at rest there.
int ExactSolver::FindSides(bool with_blow) {
  int moving = 0;
  bool is_struck = with_blow;
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
    if (out > touch_rate()) hits_.push_back({time_, i});
  }
  return moving;
}

void ExactSolver::Collide(const VecX& blow) {
  stops_.Impact(dynamics_->M(), blow, side_, sticks_, &qd_);
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
  dynamics_->AssembleHinges(lets_go ? after_release_ : time_, lets_go ? after_q_ : q_,
                            lets_go ? after_qd_ : qd_);
  stops_.Rest(dynamics_->M(), dynamics_->b(), side_, fixed_, &locked_);
  pull_before_ = StrongestPull();
  any_locked_ = std::find(locked_.begin(), locked_.end(), 1) != locked_.end();
}

// Lays the state out anew after locks or curves changed.
void ExactSolver::Relock() {
  follows_event_ = true;
  after_release_ = -std::numeric_limits<double>::infinity();
  is_cut_ = false;
  dynamics_->SetLocked(locked_, q_);
  const int size = dynamics_->layout().state_size();
  dynamics_->layout().Pack(q_, qd_, y_.data());
  step_.Resize(size);
  SetScale();
  const auto field = [this](double t, const double* y, double* dy) {
    dynamics_->Derivative(t, y, dy);
  };
  step_.Start(time_, y_.data(), field);
  last_error_ = 1.0;
}

void ExactSolver::SetScale() {
  const int positions = dynamics_->layout().num_positions();
  for (int i = 0; i < dynamics_->layout().state_size(); ++i) {
    scale_[i] = i < positions ? (dynamics_->layout().is_quaternion(i) ? 0.5 : 1.0) * tolerance_
                              : kRateScale * tolerance_;
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
  dynamics_->layout().Unpack(step_.y(), lower_now_, upper_now_, &q_, &qd_);
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
    const bool too_small = h < kLeastStep;
    if (!too_small && dynamics_->evaluations() < kMostEvaluations) continue;
    using Cause = ExactFailure::Cause;
    *failure = {dynamics_->layout().HingeOf(step_.worst_component()),
                too_small ? Cause::kStepTooSmall : Cause::kTooManyEvaluations};
    return false;
  }
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
}

EnergyFlow ExactSolver::Energy(double t) {
  MakeDense();
  step_.At(t, y_.data());
  return dynamics_->MeasureEnergy(t, y_.data());
}

std::vector<StopHit> ExactSolver::TakeHits() { return std::exchange(hits_, {}); }

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

// Which nodes' hinges could have been outside during the step: those that come nearer to a stop
// than twice the way that the rates at its ends account for.
bool ExactSolver::FindSuspects() {
  const double h = step_.end_time() - step_.start_time();
  suspects_.clear();
  const std::vector<FreeHinge>& hinges = dynamics_->hinges();
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    if (locked_[i]) continue;
    const double way =
        std::max({std::abs(qd_[i]) * h, std::abs(qd_start_[i]) * h, std::abs(q_[i] - q_start_[i])});
    const double reach = 2.0 * way + kTouch;
    if (Outside(i, q_) <= -reach && Outside(i, q_start_) <= -reach) continue;
    if (suspects_.empty() || suspects_.back() != hinges[i].node) {
      suspects_.push_back(hinges[i].node);
    }
  }
  return !suspects_.empty();
}

// The suspects' angles and rates at t, going on from the look before.
void ExactSolver::SampleSuspects(double t, VecX* q, VecX* qd) {
  step_.At(t, y_.data());
  *q = before_q_;
  for (const int node : suspects_) {
    dynamics_->layout().UnpackNode(node, y_.data(), lower_now_, upper_now_, q, qd);
  }
}

// Looks for the first time in the step at which a hinge goes out or a ball joint passes a pole, and
// ends the step there. True if a hinge goes out.
bool ExactSolver::FindHit() {
  if (!FindSuspects()) return false;
  MakeDense();
  constexpr int kLooks = 6, kFirstLooks = 5;  // what an event has pushed off may be back soon
  const double start = step_.start_time(), h = step_.end_time() - start, end = time_;
  look_q_ = q_start_;
  look_qd_ = qd_start_;
  double before = start;
  for (int look = follows_event_ ? 1 - kFirstLooks : 1; look <= kLooks; ++look) {
    const double share = look > 0 ? look : std::pow(0.25, 1 - look);
    double t = look == kLooks ? end : start + h * share / kLooks;
    before_q_.swap(look_q_);
    before_qd_.swap(look_qd_);
    look_qd_ = before_qd_;
    SampleSuspects(t, &look_q_, &look_qd_);
    const std::optional<Pole> pole = FindPole(before, t);
    if (pole) SampleSuspects(t = pole->time, &look_q_, &look_qd_);
    const std::optional<double> hit = FirstCrossing(before, t);
    if (hit) SampleSuspects(t = *hit, &look_q_, &look_qd_);
    is_cut_ = pole && !hit;
    if (is_cut_ && GoesThrough(*pole)) {
      t = std::min(end, t + kBeyondPole / std::abs(PoleRate(*pole)));
      SampleSuspects(t, &look_q_, &look_qd_);
    }
    if (hit || pole || look == kLooks) EndStepAt(t);
    if (hit || pole) return hit.has_value();
    before = t;
  }
  return false;
}

std::optional<double> ExactSolver::FirstCrossing(double before, double t) {
  std::optional<double> first;
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    for (const int side : {-1, 1}) {
      const std::optional<double> crossing = FindCrossing(i, side, before, t);
      if (crossing && (!first || *crossing < *first)) first = crossing;
    }
  }
  return first;
}

// The solution at t, where the suspects' angles are those of the last look.
void ExactSolver::EndStepAt(double t) {
  if (t < time_) {
    step_.At(t, y_.data());
    dynamics_->layout().Unpack(y_.data(), lower_now_, upper_now_, &q_, &qd_);
    time_ = t;
  }
  for (const int node : suspects_) {
    for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
      if (dynamics_->hinges()[i].node != node) continue;
      q_[i] = look_q_[i];
      qd_[i] = look_qd_[i];
    }
  }
}

// Where between two looks a ball joint is nearest to a pole, if its outer hinges whip round there.
// Up to that time and from there on they turn by less than half a turn, whose way round is certain.
std::optional<ExactSolver::Pole> ExactSolver::FindPole(double before, double t) {
  constexpr double kWhip = 1.0;  // [rad]
  std::optional<Pole> first;
  for (const int node : suspects_) {
    const HingeTriple* triple = dynamics_->layout().triple(node);
    if (!triple) continue;
    const int i = dynamics_->layout().node(node).first_hinge;
    const Vec3 way = (look_q_ - before_q_).segment<3>(i).cwiseAbs();
    if (std::max(way[0], way[2]) < kWhip) continue;
    const auto approach = [&](const VecX& q, const VecX& qd) {
      return triple->Approach(q.segment<3>(i), qd.segment<3>(i));
    };
    double a = before, b = t, fa = approach(before_q_, before_qd_),
           fb = approach(look_q_, look_qd_);
    if (fa <= 0.0 || fb >= 0.0) continue;
    for (int k = 0; k < 60 && b - a > kSameTime; ++k) {
      double m = k % 3 == 2 ? 0.5 * (a + b) : (b * fa - a * fb) / (fa - fb);
      if (!(m > a && m < b)) m = 0.5 * (a + b);
      SampleSuspects(m, &sample_q_, &sample_qd_);
      const double f = approach(sample_q_, sample_qd_);
      (f > 0.0 ? a : b) = m;
      (f > 0.0 ? fa : fb) = f;
    }
    if (a > before + kSameTime && (!first || a < first->time)) first = Pole{a, node};
  }
  return first;
}

// Whether a ball joint that is nearest to a pole goes straight through. Its outer hinges stay then,
// and the middle one, if its stops let it, is on the other side from here on, as before_q_ says.
bool ExactSolver::GoesThrough(const Pole& pole) {
  constexpr double kThrough = 1e-8;  // [rad]
  const HingeTriple& triple = *dynamics_->layout().triple(pole.node);
  const int i = dynamics_->layout().node(pole.node).first_hinge;
  const Vec3 q = look_q_.segment<3>(i);
  if (triple.FromPole(q[1]) > kThrough) return false;
  const Vec3 through = triple.ThroughPole(triple.Rotation(q), before_q_.segment<3>(i));
  if (through[1] <= lower_now_[i + 1] + kBeyondPole) return false;
  if (through[1] >= upper_now_[i + 1] - kBeyondPole) return false;
  before_q_ = look_q_;
  before_q_.segment<3>(i) = through;
  return true;
}

// Of the middle hinge [rad/s].
double ExactSolver::PoleRate(const Pole& pole) const {
  return look_qd_[dynamics_->layout().node(pole.node).first_hinge + 1];
}

// The state goes on as it is, for next to a pole angles and rates do not tell it well.
void ExactSolver::GoOnFromCut() {
  is_cut_ = false;
  step_.At(time_, y_.data());
  step_.Start(time_, y_.data(),
              [this](double t, const double* y, double* dy) { dynamics_->Derivative(t, y, dy); });
}

// How far a hinge is beyond one of its stops [rad]; negative inside.
double ExactSolver::Beyond(int hinge, int side, double q) const {
  return side > 0 ? q - upper_now_[hinge] : lower_now_[hinge] - q;
}

// When a hinge goes out between two looks: it is outside at the second one, or was in between,
// having turned back.
std::optional<double> ExactSolver::FindCrossing(int hinge, int side, double before, double t) {
  if (locked_[hinge]) return std::nullopt;
  const double f0 = Beyond(hinge, side, before_q_[hinge]), f1 = Beyond(hinge, side, look_q_[hinge]);
  if (f1 > kTouch) return CrossingTime(hinge, side, before, t);
  double g0 = side * before_qd_[hinge], g1 = side * look_qd_[hinge];
  const double h = t - before;
  if (g0 <= 0.0 || g1 >= 0.0 || std::max(f0, f1) + h * std::max(g0, -g1) <= 0.0) {
    return std::nullopt;
  }
  double a = before, b = t;
  for (int i = 0; i < 8; ++i) {  // secants on the rate, to the top of the swing
    const double top =
        std::clamp(a + (b - a) * g0 / (g0 - g1), a + 0.05 * (b - a), b - 0.05 * (b - a));
    SampleSuspects(top, &sample_q_, &sample_qd_);
    if (Beyond(hinge, side, sample_q_[hinge]) > kTouch) {
      return CrossingTime(hinge, side, before, top);
    }
    const double g = side * sample_qd_[hinge];
    (g > 0.0 ? a : b) = top;
    (g > 0.0 ? g0 : g1) = g;
  }
  return std::nullopt;
}

// Bisection and secants between a time at which the hinge is inside and one at which it is outside.
// Half of kTouch counts as inside, so that a hinge that leaves its stop has not crossed it.
double ExactSolver::CrossingTime(int hinge, int side, double inside, double outside) {
  const auto out = [&](double t) {
    SampleSuspects(t, &sample_q_, &sample_qd_);
    return Beyond(hinge, side, sample_q_[hinge]) - 0.5 * kTouch;
  };
  double a = inside, b = outside, fa = std::min(out(a), -kTouch), fb = out(b);
  for (int i = 0; i < 60 && b - a > 1e-14 && fb > 1e-14; ++i) {
    double t = i % 3 == 2 ? 0.5 * (a + b) : (a * fb - b * fa) / (fb - fa);
    if (!(t > a && t < b)) t = 0.5 * (a + b);
    const double f = out(t);
    (f > 0.0 ? b : a) = t;
    (f > 0.0 ? fb : fa) = f;
  }
  return b;
}

// The strongest pull that a stop would have to give at t to hold its hinge [N m].
double ExactSolver::Pull(double t) {
  Sample(t, &sample_q_, &sample_qd_);
  dynamics_->AssembleHinges(t, sample_q_, sample_qd_);
  stops_.Solve(dynamics_->M(), dynamics_->b(), locked_);
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
    dynamics_->AssembleHinges(after_release_, after_q_, after_qd_);
    for (size_t i = 0; i < side_.size(); ++i) side_[i] = locked_[i] ? side_[i] : 0;
    stops_.Rest(dynamics_->M(), dynamics_->b(), side_, fixed_, &held);
    if (held != locked_) break;
  }
  Sample(t, &sample_q_, &sample_qd_);
  q_ = sample_q_;
  qd_ = sample_qd_;
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
