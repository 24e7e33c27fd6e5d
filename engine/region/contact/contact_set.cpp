// With p, n as TouchPoint, v = the material's velocity at p and a its acceleration, both against
// those of the other's, g what v changes by as p glides, a direction x fixed to the contact:
//   gap'' = n a + n' v + n g,   (x v)' = x a + x g   where v is 0 along x

#include "engine/region/contact/contact_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// So slow sliding is not told from rest [m/s]: the direction of what begins to slide is known
// before.
constexpr double kSlow = 1e-6;

bool ArePairsSame(const ContactPair& a, const ContactPair& b) {
  return a.HasBodiesOf(b) && a.feature == b.feature;
}

// Pairs with obstacles come first, by capsule; then pairs of two capsules, as ContactSpec lists
// them.
bool IsBefore(const ContactPair& a, const ContactPair& b) {
  const auto key = [](const ContactPair& of) {
    const auto* obstacle = std::get_if<TouchesObstacle>(&of.partner);
    const int own = obstacle ? 0 : 1 + std::get<TouchesCapsule>(of.partner).own;
    return std::make_tuple(own, of.capsule, obstacle ? obstacle->obstacle : 0, of.feature);
  };
  return key(a) < key(b);
}

}  // namespace

Across AcrossOf(const V3& n) {
  const V3 x = std::abs(n.x) < 0.7 ? V3(1.0, 0.0, 0.0) : V3(0.0, 1.0, 0.0);
  const V3 s = x - Dot(x, n) * n, unit = (1.0 / std::sqrt(Dot(s, s))) * s;
  return {unit, Cross(n, unit)};
}

ContactSet::ContactSet(ContactSpec spec)
    : spec_(std::move(spec)), thinnest_(std::numeric_limits<double>::infinity()) {
  for (const ContactCapsule& own : spec_.capsules) thinnest_ = std::min(thinnest_, own.radius);
  pairs_.reserve(64);
  before_.reserve(64);
}

void ContactSet::Begin() {
  pairs_.clear();
  num_closed_ = 0;
}

MovingCapsule ContactSet::CapsuleAt(int capsule, const RegionState& state) const {
  const ContactCapsule& own = spec_.capsules[capsule];
  const NodeMotion& node = state.kinematics.motion()[own.node];
  const V3 a = node.R * V3(own.a), b = node.R * V3(own.b);
  return {state.PositionAt(own.node, a), state.PositionAt(own.node, b),
          state.VelocityAt(own.node, a), node.w, own.radius};
}

void ContactSet::FindPairs(const RegionState& state, double reach) {
  HAZUMI_ASSERT(reach >= 0.0);
  HAZUMI_ASSERT(!state.places.empty());
  before_.swap(pairs_);
  pairs_.clear();
  moving_.clear();
  for (int c = 0; c < static_cast<int>(spec_.capsules.size()); ++c) {
    moving_.push_back(CapsuleAt(c, state));
  }
  for (int c = 0; c < static_cast<int>(spec_.capsules.size()); ++c) {
    if (!spec_.capsules[c].meets_obstacles) continue;
    for (int o = 0; o < static_cast<int>(spec_.obstacles.size()); ++o) {
      if (IsExempt(c, o)) continue;
      if (LeastGap(moving_[c], spec_.obstacles[o]) <= reach) AddPairs({c, TouchesObstacle{o}});
    }
  }
  for (int i = 0; i < static_cast<int>(spec_.own.size()); ++i) {
    const OwnContact& own = spec_.own[i];
    // Both capsules move.
    if (LeastGap(moving_[own.a], moving_[own.b]) > 2.0 * reach) continue;
    AddPairs({own.a, TouchesCapsule{i}});
  }
  auto old = before_.begin();
  for (ContactPair& pair : pairs_) {
    while (old != before_.end() && IsBefore(*old, pair)) ++old;
    if (old != before_.end() && ArePairsSame(*old, pair)) pair = *old;
  }
  num_closed_ =
      static_cast<int>(std::count_if(pairs_.begin(), pairs_.end(), [](const ContactPair& pair) {
        return pair.mode != ContactMode::kOpen;
      }));
}

// Of the features of both, as they move in moving_.
void ContactSet::AddPairs(ContactPair pair) {
  const auto other = OtherCapsule(pair);
  for (pair.feature = 0; pair.feature < NumFeaturesOf(pair); ++pair.feature) {
    const auto point = PointOf(pair, moving_[pair.capsule], other ? &moving_[*other] : nullptr);
    pair.allowed_gap = point ? std::min(0.0, point->gap) : 0.0;
    if (point || pair.feature >= kPlanePairs) pairs_.push_back(pair);
  }
}

const OwnContact* ContactSet::OwnOf(const ContactPair& pair) const {
  const auto* touches = std::get_if<TouchesCapsule>(&pair.partner);
  return touches ? &spec_.own[touches->own] : nullptr;
}

const ContactObstacle& ContactSet::ObstacleOf(const ContactPair& pair) const {
  return spec_.obstacles[std::get<TouchesObstacle>(pair.partner).obstacle];
}

std::optional<int> ContactSet::OtherCapsule(const ContactPair& pair) const {
  const OwnContact* own = OwnOf(pair);
  return own ? std::optional(own->b) : std::nullopt;
}

ContactParts ContactSet::PartsOf(const ContactPair& pair) const {
  ContactParts parts{spec_.capsules[pair.capsule].link};
  if (const auto other = OtherCapsule(pair)) {
    parts.by_link = spec_.capsules[*other].link;
    parts.by_ball = spec_.capsules[*other].ball;
  } else {
    parts.object = ObstacleOf(pair).object;
  }
  return parts;
}

int ContactSet::NumFeaturesOf(const ContactPair& pair) const {
  return OwnOf(pair) ? kCapsulePairs : NumPairs(ObstacleOf(pair));
}

double ContactSet::FrictionOf(int pair) const {
  HAZUMI_ASSERT(0 <= pair && pair < static_cast<int>(pairs_.size()));
  const OwnContact* own = OwnOf(pairs_[pair]);
  if (own) return own->friction;
  const ContactPair& with = pairs_[pair];
  return spec_.capsules[with.capsule].friction * ObstacleOf(with).friction;
}

// That of the one that bounces more.
double ContactSet::RestitutionOf(int pair) const {
  const double own = spec_.capsules[pairs_[pair].capsule].restitution;
  const auto other = OtherCapsule(pairs_[pair]);
  return other ? std::max(own, spec_.capsules[*other].restitution) : own;
}

bool ContactSet::MayStayInside(const ContactPair& pair) const {
  const auto other = OtherCapsule(pair);
  return other && spec_.capsules[*other].ball >= 0;
}

void ContactSet::TightenGaps(const RegionState& state) {
  for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) {
    if (pairs_[i].mode != ContactMode::kOpen || pairs_[i].allowed_gap == 0.0) continue;
    const auto point = PointOf(i, state);
    if (point) pairs_[i].allowed_gap = std::clamp(point->gap, pairs_[i].allowed_gap, 0.0);
  }
}

ContactSet::Speed ContactSet::Fastest(const RegionState& state) const {
  double square = 0.0, turn = 0.0;
  for (int c = 0; c < static_cast<int>(spec_.capsules.size()); ++c) {
    const MovingCapsule moving = CapsuleAt(c, state);
    const V3 v_b = moving.v + Cross(moving.w, moving.b - moving.a);
    square = std::max({square, Dot(moving.v, moving.v), Dot(v_b, v_b)});
    turn = std::max(turn, Dot(moving.w, moving.w));
  }
  return {std::sqrt(square), std::sqrt(turn)};
}

void ContactSet::OpenAll() {
  for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) SetMode(i, ContactMode::kOpen);
}

void ContactSet::SetMode(int pair, ContactMode mode) {
  HAZUMI_ASSERT(0 <= pair && pair < static_cast<int>(pairs_.size()));
  ContactMode& own = pairs_[pair].mode;
  num_closed_ += (mode != ContactMode::kOpen) - (own != ContactMode::kOpen);
  own = mode;
}

void ContactSet::Slide(int pair, const V3& direction) {
  HAZUMI_ASSERT(IsFinite(direction));
  SetMode(pair, ContactMode::kSlide);
  ContactPair& own = pairs_[pair];
  own.direction = direction;
  own.was_fast = false;
  own.slow_steps = 0;
}

bool ContactSet::FollowSlides(const RegionState& state) {
  constexpr int kMostSlowSteps = 8;
  bool is_slow = false;
  for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) {
    ContactPair& own = pairs_[i];
    if (own.mode != ContactMode::kSlide || FrictionOf(i) == 0.0) continue;
    const auto point = PointOf(i, state);
    if (!point) continue;
    const V3 across = point->v - Dot(point->n, point->v) * point->n;
    const double speed = std::sqrt(Dot(across, across));
    if (speed < kSlowSlide) {
      is_slow |= own.was_fast || ++own.slow_steps > kMostSlowSteps;
      continue;
    }
    own.was_fast = true;
    own.direction = (1.0 / speed) * across;
  }
  return is_slow;
}

bool ContactSet::IsExempt(int capsule, int obstacle) const {
  const auto is_it = [&](const ContactExemption& exemption) {
    return exemption.capsule == capsule && exemption.obstacle == obstacle;
  };
  return std::any_of(spec_.exempt.begin(), spec_.exempt.end(), is_it);
}

bool ContactSet::IsBuried(int pair, double gap) const {
  constexpr double kMost = 0.1;      // of the axis [m]
  constexpr double kNearest = 0.25;  // of both radii, of axes to each other
  const ContactPair& own = pairs_[pair];
  if (const auto other = OtherCapsule(own)) {
    const double radii = spec_.capsules[own.capsule].radius + spec_.capsules[*other].radius;
    return gap < (kNearest - 1.0) * radii;
  }
  if (rules().feels_what_is_deep) return false;
  return ObstacleOf(own).is_box && -gap > spec_.capsules[own.capsule].radius + kMost;
}

std::optional<TouchPoint> ContactSet::PointOf(int pair, const RegionState& state) const {
  const ContactPair& own = pairs_[pair];
  const MovingCapsule moving = CapsuleAt(own.capsule, state);
  const auto other = OtherCapsule(own);
  if (!other) return PointOf(own, moving, nullptr);
  const MovingCapsule also = CapsuleAt(*other, state);
  return PointOf(own, moving, &also);
}

// `other`: its other capsule, if it has one.
std::optional<TouchPoint> ContactSet::PointOf(const ContactPair& pair, const MovingCapsule& moving,
                                              const MovingCapsule* other) const {
  ++num_samples_;
  const bool is_touching = pair.mode != ContactMode::kOpen;
  if (other) return TouchPointOf(pair.feature, moving, *other, is_touching);
  return TouchPointOf(pair.feature, moving, ObstacleOf(pair), is_touching);
}

// Direction of sliding for the velocity v of the material across n. After sliding stops within a
// step, the direction of the beginning of the step is kept until the stop is located. A current
// direction would damp the motion across it at a rate of friction / kSlow, which no step resolves
// and which amplifies rounding to centimetres per second within one step.
V3 ContactSet::SlideOf(const ContactPair& pair, const TouchPoint& point) const {
  const V3 v = point.v - Dot(point.n, point.v) * point.n;
  const V3 d = pair.direction - Dot(point.n, pair.direction) * point.n;
  const double ahead = Dot(v, d);
  const V3 across = rules().slides_straight_beyond_stop ? V3() : v - ahead * d;
  const V3 sum = ahead > 0.0 ? v + kSlow * d : across + kSlow * d;
  return (1.0 / std::sqrt(Dot(sum, sum))) * sum;
}

void ContactSet::AppendRows(const RegionState& state, std::vector<ConstraintRow>* rows) const {
  if (num_closed_ == 0) return;
  for (int i = 0; i < static_cast<int>(pairs_.size()); ++i) {
    const ContactPair& pair = pairs_[i];
    if (pair.mode == ContactMode::kOpen) continue;
    const auto point = PointOf(i, state);
    if (!point) continue;
    ConstraintRow row;
    row.constraint = ConstraintRow::kContact;
    row.contact = i;
    row.is_closed = true;
    row.a = spec_.capsules[pair.capsule].node;
    row.r_a = point->p - state.PositionAt(row.a, V3());
    if (const auto other = OtherCapsule(pair)) {
      row.b = spec_.capsules[*other].node;
      row.r_b = point->p - state.PositionAt(row.b, V3());
    }
    row.n = row.push = point->n;
    row.gap = point->gap - pair.allowed_gap;
    row.rate = Dot(point->n, point->v);
    row.bend = Dot(point->n_dot, point->v) + Dot(point->n, point->glides);
    if (pair.mode == ContactMode::kSlide && FrictionOf(i) > 0.0) {
      row.push = point->n - FrictionOf(i) * SlideOf(pair, *point);
    }
    rows->push_back(row);
    if (pair.mode == ContactMode::kSlide) continue;
    const auto [s, t] = AcrossOf(point->n);
    for (const V3& x : {s, t}) {
      row.n = row.push = x;
      row.is_across = true;
      row.gap = 0.0;
      row.rate = Dot(x, point->v);
      row.bend = Dot(x, point->glides);
      rows->push_back(row);
    }
  }
}

}  // namespace hazumi
