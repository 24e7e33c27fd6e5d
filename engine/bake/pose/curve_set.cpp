#include "engine/bake/pose/curve_set.h"

#include <algorithm>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

bool Has(const std::vector<JointIndex>& joints, JointIndex j) {
  return std::binary_search(joints.begin(), joints.end(), j);
}

// Of the regions that move a joint, unless they go on along its keys.
std::vector<double> RegionStarts(const Animation& animation, JointIndex j) {
  std::vector<double> starts;
  for (const DynamicsRegion& region : animation.regions) {
    const bool follows_keys =
        std::any_of(region.drives.begin(), region.drives.end(),
                    [j](const Drive& drive) { return FollowsKeys(drive) && Has(drive.joints, j); });
    if (Has(region.joints, j) && !follows_keys) starts.push_back(region.first_frame);
  }
  return starts;
}

// Of those that turn the root.
std::vector<double> RootRegionStarts(const Animation& animation) {
  std::vector<double> starts;
  for (const DynamicsRegion& region : animation.regions) {
    if (region.root) starts.push_back(region.first_frame);
  }
  return starts;
}

std::vector<double> PlacementStarts(const Animation& animation) {
  std::vector<double> starts;
  for (const PlacementSpan& span : animation.placements) {
    if (span.kind != PlacementKind::kKeyed) starts.push_back(span.first_frame);
  }
  return starts;
}

}  // namespace

CurveSet::CurveSet(const Animation& animation) {
  for (int j = 0; j < animation.figure->num_joints(); ++j) {
    joints_.emplace_back(&animation.joint_keys[j], animation.rate,
                         animation.figure->joints()[j].rest,
                         RegionStarts(animation, JointIndex(j)));
  }
  for (int c = 0; c < kNumRootCurves; ++c) {
    const bool is_position = c < kRootAngleZ;
    root_.emplace_back(&animation.root_keys[c], animation.rate, 0.0,
                       is_position ? PlacementStarts(animation) : RootRegionStarts(animation));
  }
}

std::vector<CurveTrack::Piece> CurveSet::PiecesBefore(double frame) {
  std::vector<CurveTrack::Piece> pieces;
  pieces.reserve(joints_.size() + root_.size());
  for (CurveTrack& track : joints_) pieces.push_back(track.PieceBefore(frame));
  for (CurveTrack& track : root_) pieces.push_back(track.PieceBefore(frame));
  return pieces;
}

void CurveSet::Restart(const std::vector<CurveTrack::Piece>& pieces) {
  HAZUMI_ASSERT(pieces.size() == joints_.size() + root_.size());
  size_t i = 0;
  for (CurveTrack& track : joints_) track.Restart(pieces[i++]);
  for (CurveTrack& track : root_) track.Restart(pieces[i++]);
}

void CurveSet::SampleJoints(double frame, Side side, const std::vector<char>& skip,
                            FigureMotion* motion) {
  HAZUMI_ASSERT(skip.size() == joints_.size());
  HAZUMI_ASSERT(motion->q.size() == static_cast<Eigen::Index>(joints_.size()));
  for (size_t j = 0; j < joints_.size(); ++j) {
    if (skip[j]) continue;
    const CurveSample sample = Sample(&joints_[j], frame, side);
    motion->q[j] = sample.value;
    motion->qd[j] = sample.rate;
    motion->qdd[j] = sample.acceleration;
  }
}

RootAngles CurveSet::RootAnglesAt(double frame, Side side) {
  RootAngles angles;
  for (int i = 0; i < 3; ++i) {
    const CurveSample sample = Sample(&root_[kRootAngleZ + i], frame, side);
    angles.angle[i] = sample.value;
    angles.rate[i] = sample.rate;
    angles.acceleration[i] = sample.acceleration;
  }
  return angles;
}

void CurveSet::SampleRootOrientation(double frame, Side side, FigureMotion* motion) {
  SetRootOrientation(RootAnglesAt(frame, side), motion);
}

void CurveSet::SampleRootPosition(double frame, Side side, FigureMotion* motion) {
  for (int i = 0; i < 3; ++i) {
    const CurveSample sample = Sample(&root_[kRootX + i], frame, side);
    motion->X_WR.p[i] = sample.value;
    motion->root.v[i] = sample.rate;
    motion->root.a[i] = sample.acceleration;
  }
}

}  // namespace hazumi
