// A pose in the order in which its parts depend on each other: joints and orientation from curves
// or regions; the root's place, which a pin and the centre of mass find from them; holds, which
// bend what was keyed so that a joint stays where it is.

#include "engine/bake/pose/pose_evaluator.h"

#include <algorithm>

namespace hazumi {

PoseEvaluator::PoseEvaluator(const Animation& animation, Recorder* recorder)
    : animation_(animation),
      figure_(*animation.figure),
      ws_(figure_),
      curves_(animation),
      objects_(animation),
      free_(figure_.num_joints(), 0),
      holds_(animation, figure_, recorder) {
  StartPlacement(nullptr);
}

void PoseEvaluator::ResetCurves() {
  curves_ = CurveSet(animation_);
  objects_.ResetCurves();
}

void PoseEvaluator::Resume(const std::vector<CurveTrack::Piece>& pieces,
                           const std::vector<ObjectState>& objects) {
  curves_.Restart(pieces);
  std::fill(free_.begin(), free_.end(), 0);
  BindRoot();
  if (objects_.states() == objects) return;
  objects_.Resume(objects);
  LoadFigure();
}

void PoseEvaluator::FreeRoot(const RootAngles& angles) {
  free_root_.emplace(RotationState{VecX(kRootAngles), VecX(kRootAngles), {}});
  for (int i = 0; i < kRootAngles; ++i) {
    free_root_->q[i] = angles.angle[i];
    free_root_->qd[i] = angles.rate[i];
  }
}

void PoseEvaluator::TurnFreeRoot(const RotationState& state) {
  if (!free_root_) return;
  free_root_->q = state.q.tail(kRootAngles);
  free_root_->qd = state.qd.tail(kRootAngles);
}

RootPlacement& PoseEvaluator::StartPlacement(const PlacementSpan* span) {
  span_ = span;
  placement_ = MakeRootPlacement(span, {animation_, figure_, curves_, ws_});
  return *placement_;
}

std::vector<double> PoseEvaluator::HandOver(const std::vector<ObjectChange>& changes,
                                            const FigureMotion& motion, const MotionLimit& before) {
  const double seconds = animation_.rate.SecondsAt(motion.frame);
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  ComputeVelocities(figure_, before.root_w, before.root_v, before.qd, &ws_);
  std::vector<double> jumps;
  for (const ObjectChange& change : changes) {
    const Vec3 from = objects_.At(change.object, motion, ws_).X_WO.p;
    if (change.holder < 0) {
      objects_.Release(change.object, objects_.states()[change.object].holder, seconds, ws_);
    } else {
      objects_.Take(change.object, change.holder);
    }
    jumps.push_back((objects_.At(change.object, motion, ws_).X_WO.p - from).norm());
  }
  LoadFigure();
  placement_->RenewFlight(seconds, motion);
  return jumps;
}

void PoseEvaluator::ReleaseWith(const FigureMotion& motion, size_t object, int holder) {
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, &ws_);
  objects_.Release(object, holder, animation_.rate.SecondsAt(motion.frame), ws_);
}

std::optional<Error> PoseEvaluator::Evaluate(double frame, Side side, FigureMotion* motion) {
  SetJoints(frame, side, motion);
  TurnRoot(frame, side, motion);
  placement_->Place(frame, side, motion);
  return SolveHolds(side, motion);
}

// Where the root's orientation comes from: a region or its curves.
void PoseEvaluator::TurnRoot(double frame, Side side, FigureMotion* motion) {
  if (!free_root_) return curves_.SampleRootOrientation(frame, side, motion);
  RootAngles angles;
  for (int i = 0; i < kRootAngles; ++i) {
    angles.angle[i] = free_root_->q[i];
    angles.rate[i] = free_root_->qd[i];
    angles.acceleration[i] = 0.0;
  }
  SetRootOrientation(angles, motion);
}

std::optional<Error> PoseEvaluator::SolveHolds(Side side, FigureMotion* motion, double tolerance) {
  if (holds_.empty()) return std::nullopt;
  return holds_.Solve(curves_.RootAnglesAt(motion->frame, side), side, tolerance, motion);
}

RotationState PoseEvaluator::StateAt(const FigureMotion& motion) {
  const int n = figure_.num_joints();
  RotationState state{VecX(n + kRootAngles), VecX(n + kRootAngles), AnchorAt(motion)};
  state.loose = motion.loose;
  state.q.head(n) = motion.q;
  state.qd.head(n) = motion.qd;
  if (free_root_) {
    state.q.tail(kRootAngles) = free_root_->q;
    state.qd.tail(kRootAngles) = free_root_->qd;
    return state;
  }
  const RootAngles angles = curves_.RootAnglesAt(motion.frame, Side::kAfter);
  for (int i = 0; i < kRootAngles; ++i) {
    state.q[n + i] = angles.angle[i];
    state.qd[n + i] = angles.rate[i];
  }
  return state;
}

PointMotion PoseEvaluator::AnchorAt(const FigureMotion& motion) {
  const RootHold hold = placement_->hold();
  if (hold.coupling == RootCoupling::kPrescribed) return {};
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  if (hold.coupling == RootCoupling::kPinned) return {ws_.body(hold.pin).p, Vec3::Zero()};
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, &ws_);
  return {CenterOfMass(figure_, ws_), CenterOfMassVelocity(figure_, ws_)};
}

bool PoseEvaluator::IsPlacedByRegions() const {
  const RootHold hold = placement_->hold();
  if (hold.coupling == RootCoupling::kFlight) return true;
  if (hold.coupling == RootCoupling::kPrescribed) return false;
  for (JointIndex j = figure_.joint(hold.pin).parent; j.is_valid(); j = figure_.joint(j).parent) {
    if (free_[j.value()]) return true;
  }
  return false;
}

}  // namespace hazumi
