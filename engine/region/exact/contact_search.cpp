// What must not be above zero, of a pair that is
//   open      allowed gap - gap           sliding   minus the speed along its direction, -push
//   sticking  -push, |drag| - friction push
//   closed    how far it is beyond where it is the nearest: what slides off an edge by its end

#include "engine/region/exact/contact_search.h"

#include <algorithm>
#include <cmath>

#include "engine/base/root.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

constexpr double kDeep = 1e-9;        // what is closed is found this deep inside [m]
constexpr double kPassed = 1e-6;      // what has ended its way is found as far behind the end [m]
constexpr double kForceSlack = 1e-8;  // of the sum of all pushes
// What points of one body share in more ways than one may be shared otherwise in a step than where
// its event was told: what it is beyond its cones there is allowed, and a little more.
constexpr double kMore = 10.0, kAtMostMore = 1e-3;
constexpr double kSameMoment = 1e-10;  // [s]
constexpr double kMargin = 1e-3;       // [m]

}  // namespace

ContactSearch::ContactSearch(RegionDynamics* dynamics, ExactStep* step)
    : dynamics_(dynamics), step_(step) {}

bool ContactSearch::Find(bool follows_event) {
  constexpr int kFewestLooks = 4, kMostLooks = 400, kFirstLooks = 4;
  ContactSet& contacts = dynamics_->mode().contacts;
  const double start = step_->start_time(), end = step_->time(), h = end - start;
  has_found_ = found_stop_ = false;
  const double speed =
      std::max(contacts.FastestEnd(step_->Glance(end)), contacts.FastestEnd(step_->Glance(start)));
  contacts.FindPairs(step_->Glance(start), 2.0 * speed * h + kMargin);
  if (contacts.pairs().empty()) return false;
  allowed_ = 0.0;
  if (follows_event && contacts.any_closed()) {
    const RowSystem::Excess excess = step_->ContactExcess(start);
    allowed_ = std::min(kMore * excess.share(), excess.share() + kAtMostMore);
    pushes_at_start_ = excess.pushes;
  }
  // So often that nothing gets through a capsule's surface in between.
  const double way = 2.0 * speed * h / contacts.thinnest();
  const int looks =
      2 * static_cast<int>(std::ceil(0.5 * std::clamp<double>(way, kFewestLooks, kMostLooks)));
  double before = start;
  step_->Glance(start);
  See(start);
  forces_before_ = start;
  for (int look = follows_event ? 1 - kFirstLooks : 1; look <= looks; ++look) {
    const double t = look == looks ? end : start + h * PlaceOfLook(look) / looks;
    const std::optional<double> change = FirstChange(before, t, look == looks || 2 * look == looks);
    if (change) {
      if (*change < end) step_->EndAt(*change);
      return has_found_ = true;
    }
    before = t;
  }
  return false;
}

bool ContactSearch::FollowToEnd() {
  ContactSet& contacts = dynamics_->mode().contacts;
  if (contacts.pairs().empty()) return false;
  const RegionState state = step_->Glance(step_->time());
  contacts.TightenGaps(state);
  return contacts.FollowSlides(state);
}

bool ContactSearch::FindBlow(const RegionState& now) {
  constexpr double kSeen = 1e-4;  // [m]
  const ContactSet& contacts = dynamics_->mode().contacts;
  const double start = step_->start_time(), end = step_->time();
  const auto gap = [&](int pair, const RegionState& state) {
    const auto point = contacts.PointOf(pair, state);
    return point ? point->gap : HUGE_VAL;
  };
  deep_.clear();
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    if (gap(i, now) < contacts.pairs()[i].allowed_gap - kSeen) deep_.push_back(i);
  }
  double first = end;
  for (const int i : deep_) {
    const double at_first = std::min(contacts.pairs()[i].allowed_gap, gap(i, step_->Glance(start)));
    const auto depth = [&](double t) { return at_first - kSeen - gap(i, step_->Glance(t)); };
    const double f = depth(first);
    if (f > 0.0) first = Narrow({start, -kSeen, first, f}, kSameMoment, depth).b;
  }
  if (first < end) step_->EndAt(first);
  return first < end;
}

std::optional<double> ContactSearch::FirstChange(double before, double t, bool looks_at_forces) {
  const ContactSet& contacts = dynamics_->mode().contacts;
  changed_.clear();
  step_->Glance(t);
  before_.swap(seen_);
  See(t);
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    if (seen_[i].change > 0.0) changed_.push_back({i, t});
  }
  for (int i = 0; i < static_cast<int>(contacts.pairs().size()); ++i) {
    if (const std::optional<double> dip = Dip(i, before, t)) changed_.push_back({i, *dip});
  }
  std::optional<double> first;
  for (const Changed& changed : changed_) {
    const auto change = [&](double at) {
      step_->Glance(at);
      return ChangeAround(changed.pair, at);
    };
    const double last = std::min(changed.time, first.value_or(changed.time));
    const double f = std::min(change(before), 0.0), f_last = change(last);
    if (f_last <= 0.0) continue;
    first = Narrow({before, f, last, f_last}, kSameMoment, change).b;
    found_stop_ = contacts.pairs()[changed.pair].mode == ContactMode::kSlide;
  }
  if ((!looks_at_forces && !first) || !contacts.any_closed()) return first;
  const auto excess = [this](double at) { return Excess(at); };
  const double last = first.value_or(t), f = excess(last);
  if (f <= 0.0) {
    forces_before_ = last;
    return first;
  }
  const double first_f = std::min(excess(forces_before_), 0.0);
  found_stop_ = false;
  return Narrow({forces_before_, first_f, last, f}, kSameMoment, excess).b;
}

// Share of forces beyond what is allowed at t. What the event left was a share of the pushes then:
// a lone push that is 0 but for rounding may pull by all of them.
double ContactSearch::Excess(double t) {
  const RowSystem::Excess now = step_->ContactExcess(t);
  double allowed = allowed_;
  const bool counts_force = dynamics_->mode().contacts.rules().opens_what_begins_to_pull;
  if (counts_force && allowed > 0.0 && now.pushes > 0.0) allowed *= pushes_at_start_ / now.pushes;
  return now.share() - std::max(kForceSlack, allowed);
}

// All pairs, where the nodes have been placed by Glance.
void ContactSearch::See(double t) {
  constexpr double kPoint = 0.03;  // cost of a point in evaluations
  const ContactSet& contacts = dynamics_->mode().contacts;
  dynamics_->AddWork({.searches = kPoint * static_cast<double>(contacts.pairs().size())});
  seen_.assign(contacts.pairs().size(), {});
  for (int i = 0; i < static_cast<int>(seen_.size()); ++i) {
    if (contacts.pairs()[i].mode != ContactMode::kOpen) {
      seen_[i].change = Change(i, t);
      continue;
    }
    const auto point = contacts.PointOf(i, step_->Glanced(t));
    if (!point) continue;
    const double gap = point->gap - contacts.pairs()[i].allowed_gap;
    seen_[i] = {-kDeep - gap, gap, Dot(point->n, point->v), true};
  }
}

// What is outside at two looks may have been inside in between: when it was deepest, if so.
std::optional<double> ContactSearch::Dip(int pair, double before, double t) {
  constexpr int kMostSecants = 8;
  constexpr double kMoreThanParabola = 3.0;
  const Seen &first = before_[pair], &last = seen_[pair];
  if (!first.is_open || !last.is_open || first.rate >= 0.0 || last.rate <= 0.0) return std::nullopt;
  if (last.gap < -kDeep) return std::nullopt;  // is found as it is
  const double way = first.rate * first.rate * (t - before) / (2.0 * (last.rate - first.rate));
  if (first.gap > kMoreThanParabola * way) return std::nullopt;
  double a = before, b = t, rate_a = first.rate, rate_b = last.rate;
  for (int i = 0; i < kMostSecants; ++i) {
    const double margin = 0.05 * (b - a);
    const double top = std::clamp(a + (b - a) * rate_a / (rate_a - rate_b), a + margin, b - margin);
    step_->Glance(top);
    if (Change(pair, top) > 0.0) return top;
    const auto point = dynamics_->mode().contacts.PointOf(pair, step_->Glanced(top));
    if (!point) return std::nullopt;
    const double rate = Dot(point->n, point->v);
    (rate < 0.0 ? a : b) = top;
    (rate < 0.0 ? rate_a : rate_b) = rate;
  }
  return std::nullopt;
}

// Of an open pair with all open ones of its capsule and obstacle: what goes in by one of a box's
// edges may be seen by a face of it later.
double ContactSearch::ChangeAround(int pair, double t) {
  const std::vector<ContactPair>& pairs = dynamics_->mode().contacts.pairs();
  const ContactPair& own = pairs[pair];
  double change = Change(pair, t);
  if (own.mode != ContactMode::kOpen) return change;
  const auto is_near = [&](const ContactPair& other) { return other.HasBodiesOf(own); };
  int first = pair;
  while (first > 0 && is_near(pairs[first - 1])) --first;
  for (int i = first; i < static_cast<int>(pairs.size()) && is_near(pairs[i]); ++i) {
    if (pairs[i].mode == ContactMode::kOpen) change = std::max(change, Change(i, t));
  }
  return change;
}

// Where the nodes have been placed by Glance.
double ContactSearch::Change(int pair, double t) {
  const ContactSet& contacts = dynamics_->mode().contacts;
  const ContactPair& own = contacts.pairs()[pair];
  const auto point = contacts.PointOf(pair, step_->Glanced(t));
  if (own.mode == ContactMode::kOpen) return point ? own.allowed_gap - kDeep - point->gap : -1.0;
  if (!point) return 1.0;
  const double passed = std::max(-1.0, point->beyond - kPassed);
  const bool may_stop = own.mode == ContactMode::kSlide && contacts.FrictionOf(pair) > 0.0;
  return may_stop ? std::max(passed, -Dot(point->v, own.direction)) : passed;
}

}  // namespace hazumi
