// With a, b the points of the ends, w_b the angular velocity of b, and everything as b sees it:
//   point      e = a - b,  along b's axes:  e' = a' - b' - w_b x e,
//              e'' = a'' - (the acceleration of b's body at a) - 2 w_b x e'
//   distance   e = |d| - L,  d = a - b,  n = d / |d|,  e'' = n d'' + (d'^2 - (n d')^2) / |d|
//   weld       a point, and phi, the turn from b's axes to a's, with phi' = w_a - w_b where it is 0
// A point's force acts where a is, on both: so that what ties two links of a figure changes neither
// of its momenta while the gap is open. A gap closes as a swing damped until it does not overshoot,
//   e'' = -2 w e' - w^2 e,   e(t) = (e_0 + (v_0 + w e_0) t) exp(-w t)

#include "engine/region/constraints/constraint_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

struct EndMotion {
  V3 p, v;  // in the world
  V3 r;     // from the node's origin
};

EndMotion MotionOf(const ConstraintSeat& seat, const RegionState& state) {
  if (seat.node == ConstraintSeat::kWorld) return {V3(seat.p), V3(), V3()};
  const V3 r = state.kinematics.motion()[seat.node].R * V3(seat.p);
  return {state.PositionAt(seat.node, r), state.VelocityAt(seat.node, r), r};
}

V3 AngularVelocityOf(const ConstraintSeat& seat, const RegionState& state) {
  return seat.node == ConstraintSeat::kWorld ? V3() : state.kinematics.motion()[seat.node].w;
}

Mat3 RotationOf(const ConstraintSeat& seat, const RegionState& state) {
  if (seat.node == ConstraintSeat::kWorld) return seat.R;
  return state.kinematics.motion()[seat.node].R.eigen() * seat.R;
}

double Closing(const ConstraintRow& row, double rate) {
  return -rate * (2.0 * row.rate + rate * row.gap);
}

}  // namespace

ConstraintSet::ConstraintSet(std::vector<ConstraintSpec> specs)
    : specs_(std::move(specs)),
      is_broken_(specs_.size(), 0),
      num_whole_(static_cast<int>(specs_.size())) {}

template <typename Predicate>
bool ConstraintSet::AnyWhole(Predicate&& is_one) const {
  for (size_t i = 0; i < specs_.size(); ++i) {
    if (!is_broken_[i] && is_one(specs_[i])) return true;
  }
  return false;
}

bool ConstraintSet::any_closed() const {
  return AnyWhole([](const ConstraintSpec& spec) { return spec.closing_rate == 0.0; });
}

bool ConstraintSet::any_closing() const {
  return AnyWhole([](const ConstraintSpec& spec) { return spec.closing_rate > 0.0; });
}

bool ConstraintSet::may_break() const {
  return AnyWhole([](const ConstraintSpec& spec) { return spec.break_force.has_value(); });
}

double ConstraintSet::FastestRate() const {
  double rate = 0.0;
  for (const ConstraintSpec& spec : specs_) rate = std::max(rate, spec.closing_rate);
  return rate;
}

void ConstraintSet::AppendRows(const RegionState& state, Rows* rows) const {
  for (int i = 0; i < static_cast<int>(specs_.size()); ++i) {
    if (is_broken_[i]) continue;
    if (specs_[i].kind == ConstraintKind::kDistance) {
      AddDistance(i, state, rows);
      continue;
    }
    AddPoint(i, state, rows);
    if (specs_[i].kind == ConstraintKind::kWeld) AddTurn(i, state, rows);
  }
}

ConstraintRow ConstraintSet::RowOf(int i, const V3& r_a, const V3& r_b) const {
  const ConstraintSpec& spec = specs_[i];
  ConstraintRow row;
  row.constraint = i;
  row.is_closed = spec.closing_rate == 0.0;
  row.a = spec.a.node;
  row.b = spec.b.node;
  row.r_a = r_a;
  row.r_b = r_b;
  return row;
}

void ConstraintSet::AddPoint(int i, const RegionState& state, Rows* rows) const {
  const ConstraintSpec& spec = specs_[i];
  const EndMotion a = MotionOf(spec.a, state), b = MotionOf(spec.b, state);
  const V3 e = a.p - b.p, w_b = AngularVelocityOf(spec.b, state);
  const V3 rate = a.v - b.v - Cross(w_b, e), bend = -2.0 * Cross(w_b, rate);
  const Mat3 axes = RotationOf(spec.b, state);
  ConstraintRow row = RowOf(i, a.r, b.r + e);
  for (int axis = 0; axis < 3; ++axis) {
    row.n = V3(Vec3(axes.col(axis)));
    row.gap = Dot(row.n, e);
    row.rate = Dot(row.n, rate);
    row.bend = Dot(row.n, bend);
    row.wanted = Closing(row, spec.closing_rate);
    rows->push_back(row);
  }
}

void ConstraintSet::AddTurn(int i, const RegionState& state, Rows* rows) const {
  const ConstraintSpec& spec = specs_[i];
  const Mat3 turn = RotationOf(spec.a, state) * RotationOf(spec.b, state).transpose();
  const Eigen::AngleAxisd phi(turn);
  const V3 w_b = AngularVelocityOf(spec.b, state);
  const V3 w = AngularVelocityOf(spec.a, state) - w_b;
  ConstraintRow row = RowOf(i, MotionOf(spec.a, state).r, MotionOf(spec.b, state).r);
  row.turns = true;
  for (int axis = 0; axis < 3; ++axis) {
    row.n = V3(Vec3::Unit(axis));
    row.gap = phi.angle() * phi.axis()[axis];
    row.rate = Dot(row.n, w);
    row.wanted = Closing(row, spec.closing_rate) + Dot(row.n, Cross(w_b, w));
    rows->push_back(row);
  }
}

void ConstraintSet::AddDistance(int i, const RegionState& state, Rows* rows) const {
  constexpr double kNoDirection = 1e-9;  // [m]
  const ConstraintSpec& spec = specs_[i];
  const EndMotion a = MotionOf(spec.a, state), b = MotionOf(spec.b, state);
  const V3 d = a.p - b.p, v = a.v - b.v;
  const double length = std::sqrt(Dot(d, d));
  ConstraintRow row = RowOf(i, a.r, b.r);
  row.n = length > kNoDirection ? (1.0 / length) * d : V3(1.0, 0.0, 0.0);
  row.gap = length - spec.length;
  row.rate = Dot(row.n, v);
  if (length > kNoDirection) row.bend = (Dot(v, v) - row.rate * row.rate) / length;
  row.wanted = Closing(row, spec.closing_rate);
  rows->push_back(row);
}

VecX ConstraintSet::Damping(const Rows& rows) const {
  VecX damping = VecX::Zero(static_cast<Eigen::Index>(rows.size()));
  for (size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].is_contact()) continue;
    damping[static_cast<Eigen::Index>(k)] =
        2.0 * specs_[rows[k].constraint].closing_rate * rows[k].rate;
  }
  return damping;
}

VecX ConstraintSet::SizesOf(const Rows& rows, const VecX& forces) const {
  HAZUMI_ASSERT(forces.size() == static_cast<Eigen::Index>(rows.size()));
  VecX sizes = VecX::Zero(static_cast<Eigen::Index>(specs_.size()));
  for (size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].turns || rows[k].is_contact()) continue;
    double& size = sizes[rows[k].constraint];
    size = std::hypot(size, forces[static_cast<Eigen::Index>(k)]);
  }
  return sizes;
}

ConstraintSet::Overload ConstraintSet::WorstOverload(const Rows& rows, const VecX& forces,
                                                     bool are_impulses) const {
  const VecX sizes = SizesOf(rows, forces);
  Overload worst;
  for (int i = 0; i < static_cast<int>(specs_.size()); ++i) {
    const std::optional<double>& stands =
        are_impulses ? specs_[i].break_impulse : specs_[i].break_force;
    if (is_broken_[i] || !stands) continue;
    const double excess = sizes[i] / *stands - 1.0;
    if (worst.constraint < 0 || excess > worst.excess) worst = {i, excess};
  }
  return worst;
}

void ConstraintSet::Break(int constraint, double t) {
  HAZUMI_ASSERT(!is_broken(constraint));
  HAZUMI_ASSERT(num_whole_ > 0);
  is_broken_[constraint] = 1;
  --num_whole_;
  breaks_.push_back({constraint, t});
}

}  // namespace hazumi
