// Where in a step a hinge reaches a stop, or a ball joint a pole.

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/root.h"
#include "engine/passive/exact_solver.h"

namespace hazumi {

namespace {

constexpr double kThrough = 1e-8;     // so near a pole goes through it [rad]
constexpr double kBeyondPole = 1e-6;  // so far from a pole its side is certain [rad]

}  // namespace

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
// ends the step there, or just beyond the pole. True if a hinge goes out.
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
    const std::optional<Crossing> hit = FirstCrossing(before, t);
    if (hit) SampleSuspects(t = hit->time, &look_q_, &look_qd_);
    is_cut_ = pole && !hit;
    const std::optional<Pole> at = hit ? PoleAt(*hit) : pole;
    if (at && Leaves(*at)) {
      t = std::min(end, t + kBeyondPole / std::abs(PoleRate(*at)));
      SampleSuspects(t, &look_q_, &look_qd_);
    }
    if (hit || pole || look == kLooks) EndStepAt(t);
    if (hit || pole) return hit.has_value();
    before = t;
  }
  return false;
}

std::optional<ExactSolver::Crossing> ExactSolver::FirstCrossing(double before, double t) {
  std::optional<Crossing> first;
  for (int i = 0; i < static_cast<int>(q_.size()); ++i) {
    for (const int side : {-1, 1}) {
      const std::optional<double> time = FindCrossing(i, side, before, t);
      if (time && (!first || *time < first->time)) first = Crossing{*time, i};
    }
  }
  return first;
}

// The solution at t, where the suspects' angles are those of the last look.
void ExactSolver::EndStepAt(double t) {
  if (t < time_) {
    step_.At(t, y_.data());
    TakeState(y_.data());
    time_ = t;
  }
  for (const int node : suspects_) {
    const int first = dynamics_->layout().node(node).first_hinge;
    for (int i = first; i < dynamics_->num_hinges(); ++i) {
      if (dynamics_->hinges()[i].node != node) break;
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
    const auto recedes = [&](const VecX& q, const VecX& qd) {
      return -triple->Approach(q.segment<3>(i), qd.segment<3>(i));
    };
    const Bracket looks = {before, recedes(before_q_, before_qd_), t, recedes(look_q_, look_qd_)};
    if (looks.fa >= 0.0 || looks.fb <= 0.0) continue;
    const double a = Narrow(looks, kSameTime, [&](double m) {
                       SampleSuspects(m, &sample_q_, &sample_qd_);
                       return recedes(sample_q_, sample_qd_);
                     }).a;
    if (a > before + kSameTime && (!first || a < first->time)) first = Pole{a, node};
  }
  return first;
}

// The pole that a ball joint is at when an outer hinge of it goes out. Both outer hinges turn about
// one axis there: an impact has nothing to push against before the joint is beyond the pole.
std::optional<ExactSolver::Pole> ExactSolver::PoleAt(const Crossing& hit) const {
  const int node = dynamics_->hinges()[hit.hinge].node;
  const HingeTriple* triple = dynamics_->layout().triple(node);
  if (!triple) return std::nullopt;
  const int middle = dynamics_->layout().node(node).first_hinge + 1;
  if (hit.hinge == middle || triple->FromPole(look_q_[middle]) > kThrough) return std::nullopt;
  return Pole{hit.time, node};
}

// Whether a ball joint at a pole goes straight through, or has just done so. Its outer hinges stay
// then, and the middle one, if its stops let it, is on the other side from here on, as before_q_
// says.
bool ExactSolver::Leaves(const Pole& pole) {
  const HingeTriple& triple = *dynamics_->layout().triple(pole.node);
  const int i = dynamics_->layout().node(pole.node).first_hinge;
  const Vec3 q = look_q_.segment<3>(i);
  if (triple.FromPole(q[1]) > kThrough) return false;
  if (triple.Approach(q, look_qd_.segment<3>(i)) < 0.0) {
    before_q_ = look_q_;
    return true;
  }
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

// Between a time at which the hinge is inside and one at which it is outside.
// Half of kTouch counts as inside, so that a hinge that leaves its stop has not crossed it.
double ExactSolver::CrossingTime(int hinge, int side, double inside, double outside) {
  const auto out = [&](double t) {
    SampleSuspects(t, &sample_q_, &sample_qd_);
    return Beyond(hinge, side, sample_q_[hinge]) - 0.5 * kTouch;
  };
  const double in = std::min(out(inside), -kTouch);
  return Narrow({inside, in, outside, out(outside)}, 1e-14, out, 1e-14).b;
}

void ExactSolver::AddHit(int hinge) {
  int& last = last_hit_[hinge];
  if (last >= 0 && time_ - hits_[last].last_time < kChatterGap) {
    ++hits_[last].count;
    hits_[last].last_time = time_;
    return;
  }
  last = static_cast<int>(hits_.size());
  hits_.push_back({time_, time_, 1, hinge});
}

std::vector<StopHit> ExactSolver::TakeHits() {
  for (const StopHit& hit : hits_) last_hit_[hit.hinge] = -1;
  return std::exchange(hits_, {});
}

}  // namespace hazumi
