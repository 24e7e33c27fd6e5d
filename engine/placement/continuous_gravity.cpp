#include "engine/placement/continuous_gravity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/root.h"
#include "engine/placement/figure_motion.h"

namespace hazumi {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Tolerances of events.
struct Tolerances {
  double depth;    // penetration at which a landing is detected [m]
  double instant;  // [s]
};
// Contacts of a region become active at 1e-9 m.
constexpr Tolerances kExact = {1e-13, 1e-14}, kVersion1 = {1e-9, 1e-10};
const Tolerances& TolerancesOf(const SolverRules& rules) {
  return rules.locates_landings_exactly ? kExact : kVersion1;
}

// More landings than this in one window, and the pin holds on for one, even if it has to pull: the
// joint that is pinned is not the point that touches, so what lifts off may go deeper at once.
constexpr int kMostLandings = 4;
constexpr double kChatterWindow = 1.0 / 30.0;  // [s]

// Within a shorter stretch the pin's force is rounding: Lift is a difference of velocities [s].
constexpr double kTellsForce = 1e-8;
// For each kilogram, less of it is rounding everywhere [m/s^2].
constexpr double kNoPull = 1e-8;

// A point that sinks or rises no faster than kHeldSpeed [m/s] is moved by rounding, or held by a
// contact of a region, to the error of the solution. A figure that does fall is faster within
// 1e-7 s. If the point touches it has not landed: the search for landings goes on from there with a
// limit kHeld [m] deeper, lowered by twice as much each time.
constexpr double kHeldSpeed = 1e-6, kHeld = 1e-10;

// Between t0, where `f` is at most zero, and t1, where it is positive: around where it turns
// positive.
template <typename Function>
Bracket Turn(double t0, double f0, double t1, double f1, double instant, Function&& f) {
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t1);
  return Narrow({t0, std::min(f0, 0.0), t1, f1}, std::max(instant, rounding), f);
}

template <typename Function>
double Root(double t0, double f0, double t1, double f1, double instant, Function&& f) {
  return Turn(t0, f0, t1, f1, instant, f).b;
}

}  // namespace

ContinuousGravity::ContinuousGravity(const Figure& figure, const std::vector<SceneObject>& scene,
                                     const PlacementSpan& span, double gravity,
                                     const SolverRules& rules)
    : figure_(figure), scene_(scene), span_(span), g_(0.0, 0.0, -gravity), rules_(rules) {}

void ContinuousGravity::PinAt(std::optional<GroupIndex> named, const Contact& contact,
                              const DynamicsWorkspace& ws) {
  state_.pin = named ? *named : NearestGroup(figure_, ws, contact.point);
  state_.pin_W = ws.body(pin_joint()).p;
  state_.normal = contact.normal;
}

void ContinuousGravity::Fly(double t, const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure_, motion.X_WR, motion.q, ws);
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
  state_.start = t;
  state_.com = CenterOfMass(figure_, *ws);
  state_.com_v = CenterOfMassVelocity(figure_, *ws);
}

void ContinuousGravity::Start(double t, const FigureMotion& motion, DynamicsWorkspace* ws) {
  Fly(t, motion, ws);
  const std::optional<Contact> contact = NearestContact(figure_, scene_, *ws);
  state_.allowed = 0.0;
  if (contact && contact->clearance <= kTouching) PinAt(span_.pin, *contact, *ws);
}

void ContinuousGravity::RenewFlight(double t, const FigureMotion& motion, DynamicsWorkspace* ws) {
  if (!state_.pin) Fly(t, motion, ws);
}

void ContinuousGravity::LeaveToContacts(double t, const FigureMotion& motion,
                                        DynamicsWorkspace* ws) {
  if (state_.is_left) return;
  state_.is_left = true;
  state_.pin.reset();
  Fly(t, motion, ws);
}

void ContinuousGravity::TakeBack(double t, const FigureMotion& motion, DynamicsWorkspace* ws) {
  if (!state_.is_left) return;
  state_.is_left = false;
  Start(t, motion, ws);
}

void ContinuousGravity::Place(double t, DynamicsWorkspace* ws, FigureMotion* motion) const {
  if (state_.pin) return PinRoot(figure_, pin_joint(), state_.pin_W, ws, motion);
  if (motion->fall) return PlaceCenterOfMass(figure_, motion->fall->p, motion->fall->v, ws, motion);
  const double s = t - state_.start;
  PlaceCenterOfMass(figure_, state_.com + state_.com_v * s + 0.5 * g_ * s * s,
                    state_.com_v + g_ * s, ws, motion);
}

FigureMotion ContinuousGravity::PlacedAt(double t, const Pose& pose, DynamicsWorkspace* ws) const {
  FigureMotion motion;
  pose(t, &motion);
  Place(t, ws, &motion);
  ComputePositions(figure_, motion.X_WR, motion.q, ws);
  return motion;
}

double ContinuousGravity::ClearanceAt(double t, const Pose& pose, DynamicsWorkspace* ws) const {
  PlacedAt(t, pose, ws);
  return Clearance(figure_, scene_, *ws);
}

std::optional<GravityEvent> ContinuousGravity::FirstEvent(double t0, double t1, const Pose& pose,
                                                          DynamicsWorkspace* ws) {
  if (state_.is_left) return std::nullopt;
  if (state_.pin) return FindTakeOff(t0, t1, pose, ws);
  const std::optional<double> apex = ApexIn(t0, t1, pose);
  const auto landing = FindLanding(t0, apex.value_or(t1), pose, ws);
  if (landing || !apex) return landing;
  return GravityEvent{GravityEvent::Kind::kApex, *apex};
}

// In (t0, t1].
std::optional<double> ContinuousGravity::ApexIn(double t0, double t1, const Pose& pose) const {
  FigureMotion motion;
  pose(t1, &motion);
  double apex = g_.z() < 0.0 ? state_.start + state_.com_v.z() / -g_.z() : kNever;
  if (motion.fall) {
    const auto sinks = [&](double t) {
      pose(t, &motion);
      return -motion.fall->v.z();
    };
    const double f0 = sinks(t0), f1 = sinks(t1);
    const double instant = TolerancesOf(rules_).instant;
    apex = f0 < 0.0 && f1 >= 0.0 ? Narrow({t0, f0, t1, f1}, instant, sinks).b : kNever;
  }
  return apex > t0 && apex <= t1 ? std::optional(apex) : std::nullopt;
}

// How much faster than freely the pinned CoM would have to fall, along the ground's normal: the
// pin's normal force for each kilogram, negated. By differences of the CoM's velocity within
// [t0, t1].
double ContinuousGravity::Lift(double t, double t0, double t1, const Pose& pose,
                               DynamicsWorkspace* ws) const {
  const double h = std::min(1e-5, (t1 - t0) / 4.0);
  const double middle = std::clamp(t, t0 + h, t1 - h);
  const auto velocity = [&](double s) {
    const FigureMotion motion = PlacedAt(s, pose, ws);
    ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
    return CenterOfMassVelocity(figure_, *ws).dot(state_.normal);
  };
  const double v0 = velocity(middle - h), v1 = velocity(middle), v2 = velocity(middle + h);
  const double acceleration = (v2 - v0) / (2.0 * h) + (v2 - 2.0 * v1 + v0) / (h * h) * (t - middle);
  return g_.dot(state_.normal) - acceleration;
}

// The point that is nearest to something, or deepest in it.
ContinuousGravity::Rise ContinuousGravity::RiseAt(double t, const Pose& pose,
                                                  DynamicsWorkspace* ws) const {
  const FigureMotion motion = PlacedAt(t, pose, ws);
  const std::optional<Contact> contact = NearestContact(figure_, scene_, *ws);
  if (!contact) return {t, kNever, -1};
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
  const BodyScratch& body = ws->body(figure_.links()[contact->link].joint);
  const Vec3 v = body.v + body.w.cross(contact->point - body.p);
  return {t, v.dot(contact->normal), contact->link};
}

// Returns a time from a to b at which it rises. Another link that is the deepest one for less than
// a millisecond may be missed.
std::optional<double> ContinuousGravity::FindRise(const Rise& a, const Rise& b, const Pose& pose,
                                                  DynamicsWorkspace* ws) const {
  constexpr double kBrief = 1e-3, kSoon = 1e-6;  // [s]
  if (a.speed > -kHeldSpeed) return a.t;
  if (b.t - a.t <= (a.link == b.link ? kBrief : kSoon)) {
    return b.speed > -kHeldSpeed ? std::optional(b.t) : std::nullopt;
  }
  const Rise m = RiseAt(0.5 * (a.t + b.t), pose, ws);
  const std::optional<double> first = FindRise(a, m, pose, ws);
  return first ? first : FindRise(m, b, pose, ws);
}

std::optional<GravityEvent> ContinuousGravity::FindTakeOff(double t0, double t1, const Pose& pose,
                                                           DynamicsWorkspace* ws) const {
  constexpr int kLooks = 4, kFirstLooks = 5;  // what has just landed may take off soon
  const bool has_landed = !state_.landings.empty() && state_.landings.back() == t0;
  const bool looks_soon = has_landed && rules_.locates_landings_exactly;
  const double instant = TolerancesOf(rules_).instant;
  const bool finds_brief = rules_.finds_brief_losses;
  const bool tells_force = t1 - t0 >= kTellsForce || !rules_.tells_motion_from_rounding;
  struct PinLook {
    double pull;
    std::optional<Rise> rise;  // while the pin pulls
    // Positive where the figure takes off.
    double lift() const { return rise ? std::min(pull, rise->speed + kHeldSpeed) : pull; }
  };
  const auto look_at = [&](double t) {
    PinLook look = {tells_force ? Lift(t, t0, t1, pose, ws) : 0.0, std::nullopt};
    if (look.pull > 0.0 && rules_.pins_what_would_sink) look.rise = RiseAt(t, pose, ws);
    return look;
  };
  const auto lift = [&](double t) { return look_at(t).lift(); };
  // Where the pin pulls between two looks, at one of which it does.
  const auto find_rise = [&](double a, const PinLook& at_a, double b, const PinLook& at_b) {
    const auto pull = [&](double t) { return Lift(t, t0, t1, pose, ws); };
    const auto eases = [&](double t) { return -pull(t); };
    const Rise first =
        at_a.rise ? *at_a.rise : RiseAt(Root(a, at_a.pull, b, at_b.pull, instant, pull), pose, ws);
    const Rise last = at_b.rise
                          ? *at_b.rise
                          : RiseAt(Turn(a, -at_a.pull, b, -at_b.pull, instant, eases).a, pose, ws);
    return FindRise(first, last, pose, ws);
  };
  const auto lifts = [&](const PinLook& look) {
    return look.lift() > 0.0 && (look.pull > kNoPull || !rules_.tells_motion_from_rounding);
  };
  const auto lost = [&](double t) { return ClearanceAt(t, pose, ws) - kTouching; };
  const double from = std::max(t0, state_.hold_until);
  if (from >= t1) return std::nullopt;
  double before = from, lost_before = lost(from);
  PinLook then = look_at(from);
  const auto take_off = [](double t) { return GravityEvent{GravityEvent::Kind::kTakeOff, t}; };
  if (lifts(then) || lost_before > 0.0) return take_off(from);
  for (int look = looks_soon ? 1 - kFirstLooks : 1; look <= kLooks; ++look) {
    const double t = look == kLooks ? t1 : from + (t1 - from) * PlaceOfLook(look) / kLooks;
    const PinLook now = look_at(t);
    const double lost_now = lost(t);
    double first = kNever;
    const auto find_from_here = [&](double later, double lift_later) {
      first = Root(before, std::min(then.lift(), 0.0), later, lift_later, instant, lift);
    };
    if (lifts(now)) {
      find_from_here(t, now.lift());
    } else if (finds_brief && std::max(then.pull, now.pull) > kNoPull) {
      const auto rise = find_rise(before, then, t, now);
      if (const double lift_then = rise ? lift(*rise) : 0.0; lift_then > 0.0) {
        find_from_here(*rise, lift_then);
      }
    }
    if (lost_now > 0.0) {
      first = std::min(first, Root(before, lost_before, t, lost_now, instant, lost));
    } else if (const auto top = finds_brief ? FindTop(before, t, pose, ws) : std::nullopt) {
      if (const double lost_at_top = lost(*top); lost_at_top > 0.0) {
        first = std::min(first, Root(before, lost_before, *top, lost_at_top, instant, lost));
      }
    }
    if (first < kNever) return take_off(first);
    before = t;
    then = now;
    lost_before = lost_now;
  }
  return std::nullopt;
}

// No point of the figure is faster than this during [t0, t1] [m/s]: the fastest of a few looks and
// a third more.
double ContinuousGravity::SpeedBound(double t0, double t1, const Pose& pose,
                                     DynamicsWorkspace* ws) const {
  constexpr int kLooks = 4;
  double fastest = 0.0;
  for (int look = 0; look <= kLooks; ++look) {
    const FigureMotion motion = PlacedAt(t0 + (t1 - t0) * look / kLooks, pose, ws);
    ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
    for (const Link& link : figure_.links()) {
      const BodyScratch& body = ws->body(link.joint);
      for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
        const double speed = (body.v + body.w.cross(body.R * end)).norm();
        fastest = std::max(fastest, speed + body.w.norm() * link.capsule.radius);
      }
    }
  }
  return 1.33 * fastest + 1e-3;
}

// Returns when the figure is farthest out between two times, if it rises at the first one and sinks
// at the second, both faster than rounding.
std::optional<double> ContinuousGravity::FindTop(double t0, double t1, const Pose& pose,
                                                 DynamicsWorkspace* ws) const {
  constexpr double kSoon = 1e-6;  // [s]
  const auto sinks = [&](double t) { return -RiseAt(t, pose, ws).speed; };
  const double f1 = sinks(t1);
  if (f1 <= kHeldSpeed) return std::nullopt;
  const double f0 = sinks(t0);
  if (f0 >= -kHeldSpeed) return std::nullopt;
  return Narrow({t0, f0, t1, f1}, kSoon, sinks).b;
}

// Depth at take-off counts as ground until the figure has been outside, or as good as outside,
// where a contact of a region may hold it. Version 1 of the solver raised it to the least depth at
// the samples.
double ContinuousGravity::RaisedGround(double clearance) const {
  if (clearance >= 0.0) return 0.0;
  if (!rules_.locates_landings_exactly) return clearance;
  return clearance >= -kHeld ? -kHeld : state_.allowed;
}

// Conservative advancement: from a time with clearance c nothing is touched for c / speed seconds.
// Touching within kTouching, as just after take-off, it goes on in short steps. What took off from
// inside is looked at the more often the nearer it is to getting out.
std::optional<GravityEvent> ContinuousGravity::FindLanding(double t0, double t1, const Pose& pose,
                                                           DynamicsWorkspace* ws) {
  const auto depth = [&](double t) { return state_.allowed - ClearanceAt(t, pose, ws); };
  const Tolerances& tolerances = TolerancesOf(rules_);
  const double speed = SpeedBound(t0, t1, pose, ws);
  double t = t0, gap = -depth(t0);
  const auto raise_ground = [&] {
    const double raised = RaisedGround(state_.allowed + gap);
    if (raised <= state_.allowed) return;
    gap -= raised - state_.allowed;
    state_.allowed = raised;
  };
  if (rules_.locates_landings_exactly) raise_ground();
  double held = kHeld;
  bool is_leaving = true;
  while (t < t1) {
    const double least = is_leaving ? (t1 - t0) / 64.0 : 1e-6;
    double way = std::max(gap / speed, least);
    const double inside = -(state_.allowed + gap);
    const bool looks_for_outside =
        rules_.locates_landings_exactly && inside > 0.0 && state_.allowed < -kHeld;
    if (looks_for_outside) way = std::min(way, std::max(inside / speed, (t1 - t0) / 64.0));
    const double next = std::min(t1, t + way);
    const double next_gap = -depth(next);
    if (looks_for_outside && state_.allowed + next_gap < 0.0) {
      const std::optional<double> top = FindTop(t, next, pose, ws);
      if (top && ClearanceAt(*top, pose, ws) >= 0.0) {
        state_.allowed = 0.0;
        t = *top;
        gap = -depth(t);
        continue;
      }
    }
    if (next_gap < -tolerances.depth) {
      const double touches = Root(t, -gap, next, -next_gap, tolerances.instant, depth);
      if (!rules_.pins_what_would_sink || RiseAt(touches, pose, ws).speed < -kHeldSpeed) {
        return GravityEvent{GravityEvent::Kind::kLanding, touches};
      }
      state_.allowed -= held;
      held *= 2.0;
      t = touches;
      gap = -depth(t);
      is_leaving = true;
      continue;
    }
    is_leaving = next_gap > gap;
    t = next;
    gap = next_gap;
    raise_ground();
  }
  return std::nullopt;
}

Vec3 ContinuousGravity::Happen(const GravityEvent& event, const FigureMotion& motion,
                               DynamicsWorkspace* ws) {
  if (event.kind == GravityEvent::Kind::kApex) return Vec3::Zero();
  if (event.kind == GravityEvent::Kind::kTakeOff) {
    Fly(event.time, motion, ws);
    const std::optional<Contact> contact = NearestContact(figure_, scene_, *ws);
    state_.allowed = contact ? std::min(0.0, contact->clearance) : 0.0;
    state_.pin.reset();
    return Vec3::Zero();
  }
  ComputePositions(figure_, motion.X_WR, motion.q, ws);
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
  PinAt(span_.landing_pin, *NearestContact(figure_, scene_, *ws), *ws);
  std::erase_if(state_.landings, [&](double t) { return t < event.time - kChatterWindow; });
  state_.landings.push_back(event.time);
  if (state_.landings.size() > kMostLandings) state_.hold_until = event.time + kChatterWindow;
  return ws->body(pin_joint()).v;
}

}  // namespace hazumi
