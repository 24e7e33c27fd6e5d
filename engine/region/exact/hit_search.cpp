#include "engine/region/exact/hit_search.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace hazumi {

namespace {

constexpr double kThrough = 1e-8;     // so near a pole goes through it [rad]
constexpr double kBeyondPole = 1e-6;  // so far from a pole its side is certain [rad]

}  // namespace

HitSearch::HitSearch(const RegionDynamics* dynamics, const LimitRange* limits, ExactStep* step)
    : dynamics_(dynamics),
      limits_(limits),
      step_(step),
      look_(dynamics->NewState()),
      before_(look_),
      sample_(look_) {
  suspects_.reserve(dynamics->num_hinges());
}

// Which nodes' hinges could have been outside during the step: those that come nearer to a limit
// than twice the way that the rates at its ends account for.
bool HitSearch::FindSuspects(const std::vector<char>& held) {
  const double h = step_->end_time() - step_->start_time();
  const HingeState &start = step_->start(), &end = step_->now();
  suspects_.clear();
  const std::vector<FreeHinge>& hinges = dynamics_->hinges();
  for (int i = 0; i < static_cast<int>(end.q.size()); ++i) {
    if (held[i]) continue;
    const double way = std::max(
        {std::abs(end.qd[i]) * h, std::abs(start.qd[i]) * h, std::abs(end.q[i] - start.q[i])});
    const double reach = 2.0 * way + kTouch;
    if (limits_->Outside(i, end.q[i]) <= -reach && limits_->Outside(i, start.q[i]) <= -reach) {
      continue;
    }
    if (suspects_.empty() || suspects_.back() != hinges[i].node) {
      suspects_.push_back(hinges[i].node);
    }
  }
  return !suspects_.empty();
}

// The suspects' angles and rates at t, going on from the look before.
void HitSearch::Look(double t, HingeState* state) {
  state->q = before_.q;
  step_->SampleNodes(t, suspects_, state);
}

HitSearch::Found HitSearch::Find(const std::vector<char>& held, bool follows_event) {
  if (!FindSuspects(held)) return Found::kNothing;
  step_->MakeDense();
  constexpr int kLooks = 6, kFirstLooks = 5;  // what an event has pushed off may be back soon
  const double start = step_->start_time(), end = step_->time();
  const double h = step_->end_time() - start;
  look_ = step_->start();
  double before = start;
  for (int look = follows_event ? 1 - kFirstLooks : 1; look <= kLooks; ++look) {
    double t = look == kLooks ? end : start + h * PlaceOfLook(look) / kLooks;
    before_.swap(look_);
    look_.qd = before_.qd;
    Look(t, &look_);
    const std::optional<Pole> pole = FindPole(before, t);
    if (pole) Look(t = pole->time, &look_);
    const std::optional<Crossing> hit = FirstCrossing(held, before, t);
    if (hit) Look(t = hit->time, &look_);
    const std::optional<Pole> at = hit ? PoleAt(*hit) : pole;
    if (at && Leaves(*at)) {
      t = std::min(end, t + kBeyondPole / std::abs(PoleRate(*at)));
      Look(t, &look_);
    }
    if (hit || pole || look == kLooks) EndStepAt(t);
    if (hit) return Found::kHit;
    if (pole) return Found::kPole;
    before = t;
  }
  return Found::kNothing;
}

std::optional<HitSearch::Crossing> HitSearch::FirstCrossing(const std::vector<char>& held,
                                                            double before, double t) {
  std::optional<Crossing> first;
  for (int i = 0; i < dynamics_->num_hinges(); ++i) {
    if (held[i]) continue;
    for (const int side : {-1, 1}) {
      const std::optional<double> time = FindCrossing(i, side, before, t);
      if (time && (!first || *time < first->time)) first = Crossing{*time, i};
    }
  }
  return first;
}

// The solution at t, where the suspects' angles are those of the last look.
void HitSearch::EndStepAt(double t) {
  if (t < step_->time()) step_->EndAt(t);
  HingeState& now = step_->now();
  for (const int node : suspects_) {
    for (int i = FirstHinge(node); i < dynamics_->num_hinges(); ++i) {
      if (dynamics_->hinges()[i].node != node) break;
      now.q[i] = look_.q[i];
      now.qd[i] = look_.qd[i];
    }
  }
}

// Where between two looks a ball joint is nearest to a pole, if its outer hinges whip round there.
// Up to that time and from there on they turn by less than half a turn, whose way round is certain.
std::optional<HitSearch::Pole> HitSearch::FindPole(double before, double t) {
  constexpr double kWhip = 1.0;  // [rad]
  std::optional<Pole> first;
  for (const int node : suspects_) {
    const HingeTriple* triple = dynamics_->layout().triple(node);
    if (!triple) continue;
    const int i = FirstHinge(node);
    const Vec3 way = (look_.q - before_.q).segment<3>(i).cwiseAbs();
    if (std::max(way[0], way[2]) < kWhip) continue;
    const auto recedes = [&](const VecX& q, const VecX& qd) {
      return -triple->Approach(q.segment<3>(i), qd.segment<3>(i));
    };
    const Bracket looks = {before, recedes(before_.q, before_.qd), t, recedes(look_.q, look_.qd)};
    if (looks.fa >= 0.0 || looks.fb <= 0.0) continue;
    const double a = Narrow(looks, kSameTime, [&](double m) {
                       Look(m, &sample_);
                       return recedes(sample_.q, sample_.qd);
                     }).a;
    if (a > before + kSameTime && (!first || a < first->time)) first = Pole{a, node};
  }
  return first;
}

// The pole that a ball joint is at when an outer hinge of it goes out. Both outer hinges turn about
// one axis there: an impact has nothing to push against before the joint is beyond the pole.
std::optional<HitSearch::Pole> HitSearch::PoleAt(const Crossing& hit) const {
  if (!IsByPole(hit.hinge, kThrough)) return std::nullopt;
  return Pole{hit.time, dynamics_->hinges()[hit.hinge].node};
}

// Whether the latest look shows an outer hinge of a ball joint that is so near to a pole [rad].
bool HitSearch::IsByPole(int hinge, double distance) const {
  const int node = dynamics_->hinges()[hinge].node;
  const HingeTriple* triple = dynamics_->layout().triple(node);
  if (!triple) return false;
  const int middle = FirstHinge(node) + 1;
  return hinge != middle && triple->FromPole(look_.q[middle]) <= distance;
}

// Whether a ball joint at a pole goes straight through, or has just done so. Its outer hinges stay
// then, and the middle one, if its limits let it, is on the other side from here on, as before_.q
// says.
bool HitSearch::Leaves(const Pole& pole) {
  const HingeTriple& triple = *dynamics_->layout().triple(pole.node);
  const int i = FirstHinge(pole.node);
  const Vec3 q = look_.q.segment<3>(i);
  if (triple.FromPole(q[1]) > kThrough) return false;
  if (triple.Approach(q, look_.qd.segment<3>(i)) < 0.0) {
    before_.q = look_.q;
    return true;
  }
  const Vec3 through = triple.ThroughPole(triple.Rotation(q), before_.q.segment<3>(i));
  if (through[1] <= limits_->limit(i + 1, -1) + kBeyondPole) return false;
  if (through[1] >= limits_->limit(i + 1, 1) - kBeyondPole) return false;
  before_.q = look_.q;
  before_.q.segment<3>(i) = through;
  return true;
}

// Of the middle hinge [rad/s].
double HitSearch::PoleRate(const Pole& pole) const { return look_.qd[FirstHinge(pole.node) + 1]; }

// When a hinge goes out between two looks: it is outside at the second one, or was in between,
// having turned back; or it came in from outside, its limit following it, and has turned out again.
std::optional<double> HitSearch::FindCrossing(int hinge, int side, double before, double t) {
  Limit limit = {hinge, side, limits_->limit(hinge, side)};
  double q0 = before_.q[hinge], g0 = side * before_.qd[hinge], g1 = side * look_.qd[hinge];
  if (rules().limits_follow_hinges && limits_->IsFurtherOut(limit.at, hinge, side) &&
      !IsByPole(hinge, kBeyondPole)) {
    limit.at = limits_->LimitFollowing(q0, hinge, side);
    if (g0 <= 0.0 && g1 > 0.0) {
      const double turn = Narrow({before, g0, t, g1}, kSameTime, [&](double at) {
                            return RateAt(at, hinge, side);
                          }).b;
      g0 = RateAt(turn, hinge, side);
      q0 = sample_.q[hinge];
      before = turn;
      limit.at = limits_->LimitFollowing(q0, hinge, side);
      const bool is_back = side * (look_.q[hinge] - q0) > kTouch;
      if (is_back && limits_->IsFurtherOut(limit.at, hinge, side)) return turn;
    }
  }
  const double out_from = rules().hits_at_one_distance ? kHitDistance : kTouch;
  const double f0 = limit.Beyond(q0), f1 = limit.Beyond(look_.q[hinge]);
  if (f1 > out_from) return CrossingTime(limit, before, t);
  const double h = t - before;
  if (g0 <= 0.0 || g1 >= 0.0 || std::max(f0, f1) + h * std::max(g0, -g1) <= 0.0) {
    return std::nullopt;
  }
  double a = before, b = t;
  for (int i = 0; i < 8; ++i) {  // secants on the rate, to the top of the swing
    const double top =
        std::clamp(a + (b - a) * g0 / (g0 - g1), a + 0.05 * (b - a), b - 0.05 * (b - a));
    Look(top, &sample_);
    if (limit.Beyond(sample_.q[hinge]) > out_from) return CrossingTime(limit, before, top);
    const double g = side * sample_.qd[hinge];
    (g > 0.0 ? a : b) = top;
    (g > 0.0 ? g0 : g1) = g;
  }
  return std::nullopt;
}

// Rate outwards at a time [rad/s]; leaves the angles there in sample_.
double HitSearch::RateAt(double t, int hinge, int side) {
  Look(t, &sample_);
  return side * sample_.qd[hinge];
}

// Between a time at which the hinge is inside and one at which it is outside.
// A hinge that is outside by rounding and on its way in has not crossed its limit until it comes
// back: else it would meet it again and again. (Version 1 of the solver counts it as a crossing
// without drives, forces and constraints, and with these does not look for its return.)
std::optional<double> HitSearch::CrossingTime(const Limit& limit, double inside, double outside) {
  const auto out = [&](double t) {
    Look(t, &sample_);
    return limit.Beyond(sample_.q[limit.hinge]) - kHitDistance;
  };
  const auto rate = [&](double t) { return RateAt(t, limit.hinge, limit.side); };
  const double in = std::min(out(inside), -kTouch);
  const double t = Narrow({inside, in, outside, out(outside)}, 1e-14, out, 1e-14).b;
  if (!rules().tells_motion_from_rounding) {
    return !dynamics_->is_pushed() || rate(t) > 0.0 ? std::optional(t) : std::nullopt;
  }
  const double rate_then = rate(t);
  if (rate_then > 0.0) return t;
  const double rate_outside = rate(outside);
  if (rate_outside <= 0.0) return std::nullopt;
  const double turns = Narrow({t, rate_then, outside, rate_outside}, kSameTime, rate).b;
  const double out_then = out(turns);
  if (out_then >= 0.0) return turns;
  return Narrow({turns, out_then, outside, out(outside)}, 1e-14, out, 1e-14).b;
}

}  // namespace hazumi
