// A gap that closes to 1 % in N frames of a figure at rest does so with the rate w of
//   (1 + w t) exp(-w t) = 0.01,   w t = 6.638352,   t = N / fps   [METHOD 11]

#include "engine/bake/walk/held_together.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hazumi {

namespace {

constexpr double kToOnePercent = 6.638352067993813;

JointIndex JointOf(const ConstraintEnd& end, const Figure& figure) {
  return end.joint ? figure.group(*end.joint).last() : JointIndex();
}

std::optional<JointIndex> TieOf(const ConstraintEnd& end, const Figure& figure) {
  if (end.is_in_world) return std::nullopt;
  return JointOf(end, figure);
}

ConstraintSeat SeatOf(const ConstraintEnd& end, const Figure& figure, const RegionModel& model) {
  if (end.is_in_world) return {ConstraintSeat::kWorld, end.offset, end.rotation};
  const NodeJoint* seat = model.SeatOf(JointOf(end, figure));
  if (!seat) return {};  // not of this island, nor is then the other end: they are tied
  return {seat->node, OnNode(*seat, end.offset), seat->R_NJ * end.rotation};
}

bool IsMoved(const ConstraintSeat& seat, const RegionModel& model) {
  return seat.node != ConstraintSeat::kWorld && model.nodes[seat.node].is_dynamic;
}

Pose PlaceOf(const ConstraintEnd& end, const Figure& figure, const Pose& X_WR,
             const DynamicsWorkspace& ws) {
  Pose own = {end.rotation, end.offset};
  if (end.is_in_world) return own;
  if (!end.joint) return X_WR * own;
  const BodyScratch& body = ws.body(JointOf(end, figure));
  return Pose{body.R, body.p} * own;
}

}  // namespace

std::vector<int> ActiveConstraints(const Animation& animation, double t,
                                   const std::vector<int>& broken) {
  std::vector<int> active;
  const double frame = animation.rate.FrameAt(t);
  for (int i = 0; i < static_cast<int>(animation.constraints.size()); ++i) {
    const Constraint& constraint = animation.constraints[i];
    if (frame < constraint.first_frame || frame >= constraint.last_frame) continue;
    if (std::find(broken.begin(), broken.end(), i) == broken.end()) active.push_back(i);
  }
  return active;
}

std::vector<ModelRequest::Tie> TiesOf(const Animation& animation,
                                      const std::vector<int>& constraints) {
  std::vector<ModelRequest::Tie> ties;
  for (const int i : constraints) {
    const Constraint& constraint = animation.constraints[i];
    ties.push_back(
        {TieOf(constraint.a, *animation.figure), TieOf(constraint.b, *animation.figure)});
  }
  return ties;
}

IslandConstraints ConstraintsOf(const RegionModel& model, const Animation& animation,
                                const std::vector<int>& constraints) {
  IslandConstraints found;
  for (const int i : constraints) {
    const Constraint& of = animation.constraints[i];
    ConstraintSpec spec;
    spec.kind = of.kind;
    spec.a = SeatOf(of.a, *animation.figure, model);
    spec.b = SeatOf(of.b, *animation.figure, model);
    const bool is_swapped = !IsMoved(spec.a, model);
    if (is_swapped) std::swap(spec.a, spec.b);  // which acts where the loose one is
    if (!IsMoved(spec.a, model)) continue;
    spec.length = of.length;
    spec.closing_rate = ClosingRate(of, animation.rate.seconds_per_frame());
    spec.break_force = of.break_force;
    spec.break_impulse = of.break_impulse;
    found.specs.push_back(spec);
    found.indices.push_back(i);
    found.are_swapped.push_back(is_swapped);
  }
  return found;
}

double ClosingRate(const Constraint& constraint, double seconds_per_frame) {
  if (constraint.arrive_frames <= 0) return 0.0;
  return kToOnePercent / (constraint.arrive_frames * seconds_per_frame);
}

ConstraintGap GapOf(const Constraint& constraint, const Figure& figure, const Pose& X_WR,
                    const DynamicsWorkspace& ws) {
  return GapBetween(constraint, PlaceOf(constraint.a, figure, X_WR, ws),
                    PlaceOf(constraint.b, figure, X_WR, ws));
}

}  // namespace hazumi
