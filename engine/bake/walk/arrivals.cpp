// Of a gap e_0 that changes with v_0 there should be left after t, with w as in held_together.cpp,
//   e(t) = (e_0 + (v_0 + w e_0) t) exp(-w t)
// Impacts on the way and rows that yield make it more. Some of that is nobody's business: what is
// told is more than a hundredth of the gap beyond it, and no less than a millimetre or half a
// degree.

#include "engine/bake/walk/arrivals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/bake/walk/held_together.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kNoted = 0.01, kLeast = 1e-3, kLeastTurn = 0.5 * kDegree;  // of the gap; [m, rad]

constexpr double kNearlyThen = 1e-6;

constexpr double kStraight = 0.2;  // largest lever of a straight limb, as a share of its length

constexpr const char* kBringIt =
    "bring its ends nearer, give it more arrive_frames, or free joints that could give way";
constexpr const char* kBendIt =
    "its limb is straight, so that no joint can draw it in; bend the limb in the frame where the "
    "constraint begins";

// A place that moves.
struct Mover {
  Pose X;
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();
};

Mover MoverOf(const ConstraintEnd& end, const Figure& figure, const DynamicsWorkspace& ws) {
  const Pose own = {end.rotation, end.offset};
  if (end.is_in_world) return {own, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  const BodyScratch& body = ws.body(end.joint ? figure.group(*end.joint).last() : JointIndex());
  const Vec3 arm = body.R * end.offset;
  return {Pose{body.R, body.p} * own, body.v + body.w.cross(arm), body.w};
}

double LeftAfter(double t, double rate, const Vec3& e, const Vec3& v) {
  return ((e + t * (v + rate * e)) * std::exp(-rate * t)).norm();
}

void Compute(const Figure& figure, const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  ComputeVelocities(figure, motion.root.w, motion.root.v, motion.qd, ws);
}

std::string Place(int constraint) { return "constraints[" + std::to_string(constraint) + "]"; }

}  // namespace

Arrivals::Gap Arrivals::GapOf(const Constraint& constraint, const DynamicsWorkspace& ws) const {
  const Mover a = MoverOf(constraint.a, *animation_.figure, ws),
              b = MoverOf(constraint.b, *animation_.figure, ws);
  const Vec3 apart = a.X.p - b.X.p;
  Gap gap;
  if (constraint.kind == ConstraintKind::kDistance) {
    gap.e.x() = apart.norm() - constraint.length;
    gap.rate.x() = apart.stableNormalized().dot(a.v - b.v);
    return gap;
  }
  gap.e = apart;
  gap.rate = a.v - b.v - b.w.cross(apart);
  if (constraint.kind != ConstraintKind::kWeld) return gap;
  const Eigen::AngleAxisd turn(a.X.R * b.X.R.transpose());
  gap.turn = turn.angle() * turn.axis();
  gap.spin = a.w - b.w;
  return gap;
}

void Arrivals::Begin(const std::vector<int>& acting, const FigureMotion& motion,
                     DynamicsWorkspace* ws) {
  bool is_computed = false;
  for (const int i : acting) {
    const Constraint& constraint = animation_.constraints[static_cast<size_t>(i)];
    auto known = std::find_if(known_.begin(), known_.end(),
                              [&](const Arrival& arrival) { return arrival.constraint == i; });
    if (constraint.arrive_frames <= 0 || (known != known_.end() && known->is_over)) continue;
    if (!is_computed) Compute(*animation_.figure, motion, ws);
    is_computed = true;
    const Gap gap = GapOf(constraint, *ws);
    if (known == known_.end()) {
      known_.push_back({i, motion.frame + constraint.arrive_frames, gap.e.norm(), gap.turn.norm()});
      known = known_.end() - 1;
    }
    known->frame = motion.frame;
    known->gap = gap;
  }
}

std::vector<Warning> Arrivals::Look(const std::vector<int>& acting, const FigureMotion& motion,
                                    const std::optional<IsFree>& is_free, DynamicsWorkspace* ws) {
  std::vector<Warning> warnings;
  bool is_computed = false;
  for (Arrival& arrival : known_) {
    const Constraint& constraint = animation_.constraints[static_cast<size_t>(arrival.constraint)];
    if (arrival.is_over || motion.frame < arrival.until - kNearlyThen) continue;
    arrival.is_over = true;
    if (std::find(acting.begin(), acting.end(), arrival.constraint) == acting.end()) continue;
    if (!is_computed) Compute(*animation_.figure, motion, ws);
    is_computed = true;
    const std::string late = LateText(arrival, motion.frame, *ws);
    if (late.empty()) continue;
    warnings.push_back({Place(arrival.constraint),
                        "\"" + constraint.name + "\" has not arrived in frame " +
                            FormatShort(motion.frame) + ": " + late + "; " +
                            (is_free && IsStraight(constraint, *is_free, *ws) ? kBendIt : kBringIt),
                        static_cast<int>(std::lround(motion.frame))});
  }
  return warnings;
}

// Returns whether an end cannot move along `way` because all free hinges that carry it lie on the
// line through it: each hinge moves the end across that line.
bool Arrivals::IsStraight(const ConstraintEnd& end, const Vec3& way, const IsFree& is_free,
                          const DynamicsWorkspace& ws) const {
  if (end.is_in_world || !end.joint) return false;
  const Figure& figure = *animation_.figure;
  const Vec3 p = MoverOf(end, figure, ws).X.p, along = way.stableNormalized();
  double lever = 0.0, reach = 0.0;
  for (JointIndex j = figure.group(*end.joint).last(); j.is_valid(); j = figure.joint(j).parent) {
    if (!is_free(j)) continue;
    const BodyScratch& hinge = ws.body(j);
    const Vec3 arm = p - hinge.p;
    lever = std::max(lever, std::abs(along.dot(hinge.axis.cross(arm))));
    reach = std::max(reach, -along.dot(arm));
  }
  return lever < kStraight * reach;
}

bool Arrivals::IsStraight(const Constraint& constraint, const IsFree& is_free,
                          const DynamicsWorkspace& ws) const {
  const Figure& figure = *animation_.figure;
  Vec3 way = MoverOf(constraint.b, figure, ws).X.p - MoverOf(constraint.a, figure, ws).X.p;
  const bool is_too_short =
      constraint.kind == ConstraintKind::kDistance && way.norm() < constraint.length;
  if (is_too_short) way = -way;
  return IsStraight(constraint.a, way, is_free, ws) || IsStraight(constraint.b, -way, is_free, ws);
}

std::string Arrivals::LateText(const Arrival& arrival, double frame,
                               const DynamicsWorkspace& ws) const {
  const Constraint& constraint = animation_.constraints[static_cast<size_t>(arrival.constraint)];
  const double per_frame = animation_.rate.seconds_per_frame();
  const double rate = ClosingRate(constraint, per_frame);
  const double t = (frame - arrival.frame) * per_frame;
  const Gap left = GapOf(constraint, ws), &first = arrival.gap;
  const double meant = LeftAfter(t, rate, first.e, first.rate);
  if (left.e.norm() > meant + std::max(kNoted * arrival.size, kLeast)) {
    return FormatShort(1000.0 * left.e.norm()) + " mm of its gap are left, where " +
           FormatShort(1000.0 * meant) + " mm should be";
  }
  const double meant_turn = LeftAfter(t, rate, first.turn, first.spin);
  if (left.turn.norm() > meant_turn + std::max(kNoted * arrival.turn, kLeastTurn)) {
    return FormatShort(left.turn.norm() / kDegree) + " degrees of its gap are left, where " +
           FormatShort(meant_turn / kDegree) + " should be";
  }
  return "";
}

std::vector<Warning> Arrivals::Break(int constraint, double frame) {
  const Constraint& broken = animation_.constraints[static_cast<size_t>(constraint)];
  for (Arrival& arrival : known_) {
    if (arrival.constraint != constraint || arrival.is_over) continue;
    arrival.is_over = true;
    return {{Place(constraint),
             "\"" + broken.name + "\" broke in frame " + FormatShort(frame) +
                 ", before it had closed its gap; give it more arrive_frames, or let it stand more",
             static_cast<int>(std::lround(frame))}};
  }
  return {};
}

}  // namespace hazumi
