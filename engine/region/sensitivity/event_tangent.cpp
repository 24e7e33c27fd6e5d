// At an event of the motion x' = f(x, t), with x- before it, x+ = R(x-, t) after it, and g(x, t) =
// 0 where it happens, changes dx- become dx+ = S dx- [Kong, Payne, Zhu, Johnson 2024]:
//   S = D_x R + (f+ - D_x R f- - D_t R) (D_x g)^T / (D_t g + D_x g . f-).
// A limit is hit: x = (q, v), g = side (q_k - limit_k), and R is the impact that stops the hinges
// A,
//   q+ = q,   v_A+ = 0,   v_F+ = v_F + M_FF^-1 M_FA v_A     (F: all others, M at (q, t)).
// R is linear in v. Its derivative by q is a central difference with steps of 1e-5 rad, whose error
// is some 1e-10 of it; that by t likewise, where driven nodes are between free ones.
// A limit lets go: R is the identity, and g is the torque T_k of the limit. f+ = f- then, so that
// S = 1, with two exceptions:
// - Laws may treat a ball joint otherwise if a limit holds one of its hinges: f+ - f- is what it
// is.
// - Where a ball joint passes a pole with an outer hinge k at its limit, the axes of k and of the
// free
//   outer hinge line up. The moment of the limit is M = T_k c / sin(d), with d the distance from
//   the pole and c a unit vector, and is finite: T_k changes its sign with d, and M drops to zero.
//   There g is the angle of the middle hinge, and f+ - f- is taken by dof of the ball joint.

#include "engine/region/sensitivity/event_tangent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/region/exact/sticky_limits.h"
#include "engine/region/sensitivity/state_tangent.h"

namespace hazumi {

namespace {

constexpr double kAtItsLimit = 1e-9;      // [rad]
constexpr double kTurnOfImpact = 1e-5;    // [rad]
constexpr double kRateOfPull = 1e-4;      // [rad/s]
constexpr double kInstantOfEvent = 1e-5;  // [s]
constexpr double kSameImpact = 1e-7;      // relative

double OneAndLargest(const VecX& x) { return 1.0 + x.lpNorm<Eigen::Infinity>(); }

}  // namespace

std::vector<char> LockedHinges(const RegionLayout& layout) {
  std::vector<char> locked;
  for (const FreeHinge& hinge : layout.hinges()) {
    locked.push_back(layout.node(hinge.node).locked[static_cast<size_t>(hinge.slot)]);
  }
  return locked;
}

EventTangent::EventTangent(RegionDynamics* dynamics, VecX lower, VecX upper)
    : dynamics_(dynamics),
      lower_(std::move(lower)),
      upper_(std::move(upper)),
      forces_(dynamics),
      probe_(dynamics->NewState()) {
  const std::vector<ModelNode>& nodes = dynamics->model().nodes;
  is_moved_inside_ = std::any_of(nodes.begin(), nodes.end(), [](const ModelNode& node) {
    return node.role == Role::kDriven && node.is_dynamic;
  });
  const auto n = static_cast<size_t>(dynamics->num_hinges());
  stopped_.assign(n, 0);
  sticks_.assign(n, 0);
}

int EventTangent::SideAt(int hinge, double q) const {
  if (q >= upper_[hinge] - kAtItsLimit) return 1;
  return q <= lower_[hinge] + kAtItsLimit ? -1 : 0;
}

// Hinges at a limit that are at rest after the event.
void EventTangent::ListStopped(const BeforeEvent& before, const AfterEvent& after) {
  const std::vector<char> held_after = LockedHinges(after.layout);
  const double at_rest = 1e-11 * OneAndLargest(before.state.qd);
  for (int i = 0; i < dynamics_->num_hinges(); ++i) {
    const auto index = static_cast<size_t>(i);
    const int side = SideAt(i, after.state.q[i]);
    const bool rests = held_after[index] || std::abs(after.state.qd[i]) <= at_rest;
    stopped_[index] = rests ? side : 0;
    sticks_[index] = stopped_[index] != 0;
  }
}

std::optional<EventJump> EventTangent::Find(double t, double start, double end,
                                            const BeforeEvent& before, const AfterEvent& after,
                                            bool at_fixed_time) {
  held_before_ = LockedHinges(before.layout);
  ListStopped(before, after);
  const Instant at = {t, before.state.q, before.state.qd};
  const std::vector<char> held_after = LockedHinges(after.layout);
  bool any_comes = false, any_goes = false;
  for (size_t i = 0; i < held_after.size(); ++i) {
    any_comes |= held_after[i] && !held_before_[i];
    any_goes |= !held_after[i] && held_before_[i];
  }
  constexpr double kSameRates = 1e-6, kSameButRounding = 1e-11;
  const bool only_goes = any_goes && !any_comes;
  if (any_comes || RatesJump(at, after, only_goes ? kSameRates : kSameButRounding)) {
    return OfHit(at, start, end, before, after);
  }
  if (any_goes && !at_fixed_time) return OfRelease(at, start, end, before, after);
  EventJump none;
  none.S = DofsFromHinges(after.layout, at.q, at.qd);
  return none;
}

// Compares velocities by dof: at a pole rates of hinges do not tell what moves.
bool EventTangent::RatesJump(const Instant& before, const AfterEvent& after, double most) const {
  const RegionLayout& layout = after.layout;
  if (layout.num_dofs() == 0) return false;
  VecX y(layout.state_size());
  layout.Pack(before.q, before.qd, y.data());
  const VecX v = y.tail(layout.num_dofs());
  return (after.velocities - v).lpNorm<Eigen::Infinity>() > most * OneAndLargest(v);
}

// Rates after the impact that stops the hinges stopped_.
VecX EventTangent::Impact(const Instant& at) {
  probe_.q = at.q;
  probe_.qd = at.qd;
  forces_.Impact(at.t, stopped_, sticks_, &probe_, LimitForces::Strikes::kHingesAlone);
  return probe_.qd;
}

// n x 2 n, by angles and by rates.
MatX EventTangent::ImpactDerivatives(const Instant& at) {
  const int n = dynamics_->num_hinges();
  MatX D(n, 2 * n);
  Instant shifted = at;
  for (int j = 0; j < n; ++j) {
    shifted.q[j] = at.q[j] + kTurnOfImpact;
    const VecX more = Impact(shifted);
    shifted.q[j] = at.q[j] - kTurnOfImpact;
    D.col(j) = (more - Impact(shifted)) / (2.0 * kTurnOfImpact);
    shifted.q[j] = at.q[j];
  }
  for (int j = 0; j < n; ++j) {
    shifted.qd = VecX::Unit(n, j);
    D.col(n + j) = Impact(shifted);
  }
  return D;
}

// Derivative by time alone.
VecX EventTangent::ImpactChange(const Instant& at, double start, double end) {
  const double from = std::max(start, at.t - kInstantOfEvent),
               to = std::min(end, at.t + kInstantOfEvent);
  if (!is_moved_inside_ || !(to > from)) return VecX::Zero(at.q.size());
  return (Impact({to, at.q, at.qd}) - Impact({from, at.q, at.qd})) / (to - from);
}

std::optional<EventJump> EventTangent::OfHit(const Instant& at, double start, double end,
                                             const BeforeEvent& before, const AfterEvent& after) {
  const int n = dynamics_->num_hinges();
  if ((Impact(at) - after.state.qd).lpNorm<Eigen::Infinity>() >
      kSameImpact * OneAndLargest(at.qd)) {
    return std::nullopt;
  }
  EventJump jump;
  jump.kind = LimitEvent::kHit;
  for (int i = 0; i < n; ++i) {
    const auto index = static_cast<size_t>(i);
    if (held_before_[index]) continue;
    const double rate = SideAt(i, at.q[i]) * at.qd[i];
    if (rate > std::max(jump.rate, StickyLimits::least_rest_rate())) {
      if (jump.hinge >= 0) jump.also_stopped.push_back(jump.hinge);
      jump.hinge = i;
      jump.rate = rate;
    } else if (stopped_[index] != 0 || rate > StickyLimits::least_rest_rate()) {
      jump.also_stopped.push_back(i);
    }
  }
  MatX DR = MatX::Identity(2 * n, 2 * n);
  DR.bottomRows(n) = ImpactDerivatives(at);
  const MatX to_dofs = DofsFromHinges(after.layout, after.state.q, after.state.qd);
  jump.S = to_dofs * DR;
  if (jump.hinge < 0) {
    jump.is_one_sided = jump.also_stopped.empty();
    return jump;
  }
  VecX flow(2 * n), flow_after(to_dofs.rows());
  flow << at.qd, before.qdd;
  flow_after << after.velocities, after.accelerations;
  VecX moved = DR * flow;
  moved.tail(n) += ImpactChange(at, start, end);
  jump.S.col(jump.hinge) += (flow_after - to_dofs * moved) / at.qd[jump.hinge];
  return jump;
}

// Torque that the limit of a hinge gives while all that is held before is held [N m].
double EventTangent::Pull(int hinge, const Instant& at) {
  probe_.q = at.q;
  probe_.qd = at.qd;
  forces_.Hold(at.t, probe_, held_before_);
  return forces_.T()[hinge];
}

VecX EventTangent::PullGradient(int hinge, const Instant& at) {
  const int n = dynamics_->num_hinges();
  VecX gradient = VecX::Zero(2 * n);
  Instant shifted = at;
  for (int j = 0; j < 2 * n; ++j) {
    if (held_before_[static_cast<size_t>(j % n)]) continue;
    double& x = j < n ? shifted.q[j] : shifted.qd[j - n];
    const double here = x, step = j < n ? kTurnOfImpact : kRateOfPull;
    x = here + step;
    const double more = Pull(hinge, shifted);
    x = here - step;
    gradient[j] = (more - Pull(hinge, shifted)) / (2.0 * step);
    x = here;
  }
  return gradient;
}

// Along the motion that goes on being held.
double EventTangent::PullRate(int hinge, const Instant& at, double start, double end,
                              const VecX& qdd) {
  const double from = std::max(start, at.t - kInstantOfEvent);
  const double to = std::min(end, at.t + kInstantOfEvent);
  const auto along = [&](double t) {
    const double s = t - at.t;
    return Pull(hinge, {t, at.q + s * at.qd, at.qd + s * qdd});
  };
  return (along(to) - along(from)) / (to - from);
}

// The middle hinge of the ball joint that an outer hinge is of, if that is at a pole.
std::optional<int> EventTangent::MiddleAtPole(int hinge, const Instant& at) const {
  constexpr double kAtOnce = 2e-6;  // [s]
  const int node = dynamics_->hinges()[static_cast<size_t>(hinge)].node;
  const HingeTriple* ball = dynamics_->layout().unlocked_triple(node);
  if (!ball) return std::nullopt;
  const int middle = dynamics_->layout().node(node).first_hinge + 1;
  const bool is_there = ball->FromPole(at.q[middle]) <= kAtOnce * std::abs(at.qd[middle]);
  return hinge != middle && is_there ? std::optional(middle) : std::nullopt;
}

EventJump EventTangent::OfRelease(const Instant& at, double start, double end,
                                  const BeforeEvent& before, const AfterEvent& after) {
  constexpr double kSameForce = 1e-5;  // relative
  const int n = dynamics_->num_hinges(), m = after.layout.num_dofs();
  EventJump jump;
  jump.kind = LimitEvent::kRelease;
  const std::vector<char> held_after = LockedHinges(after.layout);
  int released = 0;
  for (int i = 0; i < n; ++i) {
    const auto index = static_cast<size_t>(i);
    if (!held_before_[index] || held_after[index]) continue;
    ++released;
    if (jump.hinge < 0) jump.hinge = i;
  }
  // Map from what moves after the event to what moves before it.
  const MatX to_dofs = DofsFromHinges(after.layout, at.q, at.qd);
  jump.S = to_dofs;
  VecX flow(2 * n);
  flow << at.qd, before.qdd;
  const VecX change = after.accelerations - (to_dofs * flow).tail(m);
  if (m == 0 || change.lpNorm<Eigen::Infinity>() <= kSameForce * OneAndLargest(before.qdd))
    return jump;
  jump.is_one_sided = released > 1;
  if (const std::optional<int> middle = MiddleAtPole(jump.hinge, at)) {
    jump.S.col(*middle).tail(m) += change / at.qd[*middle];
    return jump;
  }
  const double rate = PullRate(jump.hinge, at, start, end, before.qdd);
  jump.S.bottomRows(m) += change * PullGradient(jump.hinge, at).transpose() / rate;
  return jump;
}

}  // namespace hazumi
