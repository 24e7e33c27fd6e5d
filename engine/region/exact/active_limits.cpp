#include "engine/region/exact/active_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hazumi {

namespace {

// Of contacts: how near is touching, how slow at rest.
constexpr double kTouchGap = 1e-8;   // [m]
constexpr double kRestSpeed = 1e-6;  // [m/s]

}  // namespace

ActiveLimits::ActiveLimits(RegionDynamics* dynamics, const LimitRange* limits)
    : dynamics_(dynamics),
      limits_(limits),
      forces_(dynamics),
      contact_forces_(dynamics),
      sticky_(dynamics->mode().contacts.rules(), dynamics->num_hinges()) {
  side_.assign(dynamics->num_hinges(), 0);
  side_of_rest_ = side_;
  for (std::vector<char>* flags : {&held_, &sticks_, &fixed_, &held_later_}) {
    flags->assign(dynamics->num_hinges(), 0);
  }
}

void ActiveLimits::Begin() {
  sticky_.Begin();
  dynamics_->mode().contacts.Begin();
  std::fill(held_.begin(), held_.end(), 0);
}

uint64_t ActiveLimits::StateSum() const {
  uint64_t sum = 0;
  for (size_t i = 0; i < held_.size(); ++i) {
    if (held_[i]) sum += HashOf(i, side_[i]);
  }
  const std::vector<ContactPair>& pairs = dynamics_->mode().contacts.pairs();
  for (size_t i = 0; i < pairs.size();) {  // points of one capsule on one obstacle count once
    bool touches = false, slides = false;
    const ContactPair& first = pairs[i];
    for (; i < pairs.size() && first.HasBodiesOf(pairs[i]); ++i) {
      touches |= pairs[i].mode != ContactMode::kOpen;
      slides |= pairs[i].mode == ContactMode::kSlide;
    }
    if (!touches) continue;
    const auto* obstacle = std::get_if<TouchesObstacle>(&first.partner);
    sum += obstacle ? HashOf(-1, first.capsule, obstacle->obstacle, slides)
                    : HashOf(-3, std::get<TouchesCapsule>(first.partner).own, slides);
  }
  const ConstraintSet& constraints = dynamics_->mode().constraints;
  for (int i = 0; i < static_cast<int>(constraints.specs().size()); ++i) {
    if (constraints.is_broken(i)) sum += HashOf(-2, i);
  }
  return sum;
}

void ActiveLimits::LetGo() {
  is_touching_ = false;
  any_ = false;
  for (int i = 0; i < static_cast<int>(held_.size()); ++i) held_[i] = limits_->is_fixed(i);
}

bool ActiveLimits::Touches(double t, const HingeState& state) {
  if (!dynamics_->mode().contacts.is_possible()) return false;
  contact_forces_.SetTouch(kTouchGap, kRestSpeed);
  return contact_forces_.FindTouching(t, state);
}

void ActiveLimits::Resolve(double t, const HingeMoment* later, HingeState* state, ImpactLog* log) {
  is_touching_ = Touches(t, *state);
  if (contact_forces_.is_order_unsure()) log->NoteUnsure();
  const bool with_impulse =
      !state->pin_velocity.isZero(0.0) || dynamics_->mode().constraints.any() || is_touching_;
  const int moving = limits_->any() ? FindSides(t, with_impulse, *state, log) : 0;
  const bool is_blocked =
      std::any_of(side_.begin(), side_.end(), [](int side) { return side != 0; });
  dynamics_->mode().least_compliance = is_blocked ? RegionMode::kBlocked : 0.0;
  if (with_impulse || moving > 0) Collide(t, state, log);
  Settle(t, later, state);
}

// The hinges at a limit; those on their way in only where an impulse or another hinge's impact may
// send them out. Returns how many are not at rest there.
int ActiveLimits::FindSides(double t, bool with_impulse, const HingeState& state, ImpactLog* log) {
  const VecX &q = state.q, &qd = state.qd;
  int moving = 0;
  bool is_struck = with_impulse;
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    side_[i] = 0;
    if (q[i] >= limits_->limit(i, 1) - sticky_.distance(i)) side_[i] = 1;
    if (q[i] <= limits_->limit(i, -1) + sticky_.distance(i)) side_[i] = -1;
    fixed_[i] = limits_->is_fixed(i);
    if (fixed_[i]) side_[i] = 1;
    is_struck |= fixed_[i] ? qd[i] != 0.0 : side_[i] * qd[i] > sticky_.rest_rate(i);
  }
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    if (fixed_[i]) {
      sticks_[i] = 1;
      moving += qd[i] != 0.0;
      continue;
    }
    const double out = side_[i] * qd[i];
    if (out < -sticky_.rest_rate(i) && !is_struck) side_[i] = 0;
    sticks_[i] = side_[i] != 0 && out < 0.0 && out >= -sticky_.rest_rate(i);
    moving += side_[i] != 0 && out != 0.0;
    if (out > sticky_.rest_rate(i)) log->AddHit(i, t);
    if (side_[i] != 0 && !held_[i]) sticky_.CountArrival(i, t);
  }
  return moving;
}

// A hinge that an impact pushes off its limit, but not for long, is stopped by an impulse, too: the
// others feel what the limit would give them until the hinge is back. [METHOD 3.5]
void ActiveLimits::Collide(double t, HingeState* state, ImpactLog* log) {
  const bool is_tied = dynamics_->mode().constraints.any() || is_touching_;
  if (dynamics_->mode().contacts.rules().stops_by_impulse) StopSlow(t, state);
  bool any_stops = true;
  while (any_stops) {
    is_tied ? CollideTied(t, state) : Strike(t, state);
    state->pin_velocity.setZero();
    any_stops = false;
    std::optional<AtRest> at_rest;  // with these sides
    for (int i = 0; i < static_cast<int>(side_.size()); ++i) {
      if (!IsPushedOff(i, *state)) continue;
      if (!FallsBack(t, i, *state, &at_rest)) {
        side_[i] = 0;
        at_rest.reset();
      } else if (stops_by_impulse() && !sticks_[i]) {
        sticks_[i] = 1;
        any_stops = true;
      }
    }
  }
  if (is_touching_) TellOfContacts(t, log);
}

// Stops what leaves its limit slowly before the impact of what is struck: that may push it off, and
// no limit pulls against it.
void ActiveLimits::StopSlow(double t, HingeState* state) {
  const RegionMode& mode = dynamics_->mode();
  bool any_slow = false;
  bool is_struck = is_touching_ || mode.constraints.any() || !state->pin_velocity.isZero(0.0);
  for (size_t i = 0; i < side_.size(); ++i) {
    const bool goes_out = fixed_[i] ? state->qd[i] != 0.0 : side_[i] * state->qd[i] > 0.0;
    is_struck |= goes_out;
    any_slow |= sticks_[i] && !fixed_[i];
    side_of_rest_[i] = goes_out ? 0 : side_[i];
  }
  if (!any_slow || !is_struck) return;
  forces_.Impact(t, side_of_rest_, sticks_, state, LimitForces::Strikes::kHingesAlone);
  if (mode.any_rows()) {
    const std::vector<ConstraintRow>& rows = dynamics_->rows().rows();
    state->outer.Jump(dynamics_->bodies().VelocityChanges(rows, forces_.row_impulses()));
  }
  sticks_ = fixed_;
}

// Contacts' work is that of one impact.
bool ActiveLimits::stops_by_impulse() const {
  return dynamics_->mode().contacts.rules().stops_by_impulse && !is_touching_;
}

bool ActiveLimits::IsPushedOff(int hinge, const HingeState& state) const {
  const double at_rest =
      stops_by_impulse() ? StickyLimits::least_rest_rate() : sticky_.rest_rate(hinge);
  return side_[hinge] * state.qd[hinge] < -at_rest;
}

void ActiveLimits::TellOfContacts(double t, ImpactLog* log) const {
  if (!contact_forces_.has_solved_impact()) log->NoteUnsure();
  const ContactSet& contacts = dynamics_->mode().contacts;
  const double limits = contact_forces_.limit_work();
  log->AddWork({limits, contact_forces_.work() - limits, /*has_contacts=*/true});
  for (const int pair : contact_forces_.struck()) {
    log->AddTouch(contacts.PartsOf(contacts.pairs()[pair]), contacts.BallOf(pair), t);
  }
}

// Whether a hinge that an impact pushes off its limit is back before it is further away than counts
// as at it. Where two hinges push each other off in turn their hits come faster and faster and end
// at once; each hit is found as late as that, which would keep them going.
bool ActiveLimits::FallsBack(double t, int hinge, const HingeState& state,
                             std::optional<AtRest>* at_rest) {
  constexpr double kSlow = 0.01;  // [rad/s]
  const double at_rest_rate = sticky_.rest_rate(hinge);
  const double rate = -side_[hinge] * state.qd[hinge];
  const bool may_fall_back =
      stops_by_impulse() || (dynamics_->is_pushed() && !dynamics_->is_large() && !is_touching_);
  if (rate > at_rest_rate && (rate > kSlow || !may_fall_back)) return false;
  if (!*at_rest) *at_rest = RestAtLimits(t, state);
  if (!(*at_rest)->held[hinge] || rate <= at_rest_rate) return (*at_rest)->held[hinge];
  std::vector<char> held = (*at_rest)->held;
  held[hinge] = 0;
  forces_.Hold(t, (*at_rest)->state, held);
  const double back = side_[hinge] * forces_.x()[hinge], height = 4.0 * sticky_.distance(hinge);
  return rate * rate <= 2.0 * back * height;
}

ActiveLimits::AtRest ActiveLimits::RestAtLimits(double t, const HingeState& state) {
  AtRest rest = {state, std::vector<char>(side_.size())};
  for (size_t i = 0; i < side_.size(); ++i) {
    if (side_[i] == 0) continue;
    rest.state.qd[i] = 0.0;
    rest.state.q[i] = limits_->limit(static_cast<int>(i), side_[i]);
  }
  forces_.Rest(t, rest.state, side_, fixed_, &rest.held);
  return rest;
}

void ActiveLimits::Strike(double t, HingeState* state) {
  if (is_touching_) {
    contact_forces_.Impact(t, side_, sticks_, state);
  } else {
    forces_.Impact(t, side_, sticks_, state);
  }
}

// Constraints break before they give more than they stand.
void ActiveLimits::CollideTied(double t, HingeState* state) {
  ConstraintSet& constraints = dynamics_->mode().constraints;
  const VecX before = state->qd;
  for (;;) {
    Strike(t, state);
    if (!dynamics_->mode().any_rows()) return;
    const VecX& impulses = is_touching_ ? contact_forces_.row_impulses() : forces_.row_impulses();
    const std::vector<ConstraintRow>& rows = dynamics_->rows().rows();
    const auto worst = constraints.WorstOverload(rows, impulses, /*are_impulses=*/true);
    if (worst.excess <= 0.0) {
      return state->outer.Jump(dynamics_->bodies().VelocityChanges(rows, impulses));
    }
    constraints.Break(worst.constraint, t);
    state->qd = before;
  }
}

// Holds the hinges at rest that their limits go on holding.
void ActiveLimits::Settle(double t, const HingeMoment* later, HingeState* state) {
  any_ = false;
  std::fill(held_.begin(), held_.end(), 0);
  bool any_at_limit = false;
  for (int i = 0; i < static_cast<int>(side_.size()); ++i) {
    if (side_[i] == 0) continue;
    any_at_limit = true;
    state->qd[i] = 0.0;
    state->q[i] = limits_->limit(i, side_[i]);
  }
  if (is_touching_) {
    contact_forces_.Rest(t, *state, side_, fixed_, &held_);
    any_ = std::find(held_.begin(), held_.end(), 1) != held_.end();
    return;
  }
  if (!any_at_limit) return;
  if (later) {
    forces_.Rest(later->time, later->state, side_, fixed_, &held_);
  } else {
    forces_.Rest(t, *state, side_, fixed_, &held_);
  }
  any_ = std::find(held_.begin(), held_.end(), 1) != held_.end();
}

double ActiveLimits::StrongestPull() const {
  double most = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < held_.size(); ++i) {
    if (held_[i] && !fixed_[i]) most = std::max(most, side_[i] * T()[i]);
  }
  return most;
}

double ActiveLimits::PullAt(double t, const HingeState& state) {
  forces_.Hold(t, state, held_);
  is_touching_ = false;  // from here on these forces are the latest ones
  return StrongestPull();
}

bool ActiveLimits::PullsByRounding() const {
  if (!dynamics_->mode().contacts.rules().tells_motion_from_rounding) return false;
  for (int i = 0; i < static_cast<int>(held_.size()); ++i) {
    if (held_[i] && !fixed_[i] && side_[i] * T()[i] > forces_.RoundingOf(i)) return false;
  }
  return true;
}

bool ActiveLimits::WouldHoldAll(const HingeMoment& moment) {
  for (size_t i = 0; i < side_.size(); ++i) side_[i] = held_[i] ? side_[i] : 0;
  forces_.Rest(moment.time, moment.state, side_, fixed_, &held_later_);
  return held_later_ == held_;
}

}  // namespace hazumi
