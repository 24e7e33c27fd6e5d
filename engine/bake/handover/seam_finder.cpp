// At a border of frame F, of each hinge that it concerns and of the root (R, p):
//   jump of the angle         q(F+) - q(F-), without whole turns,
//   of the rate               q'(F+) - q'(F-),
//   of the acceleration       q''(F+) - q''(F-),
//   of the root               the angle of R(F+) R(F-)^T, |w(F+) - w(F-)|, |w'(F+) - w'(F-)|,
//                             |p(F+) - p(F-)| and so on.
// Both limits are those of the bake itself: curves by their own formulas, what regions drive by
// their equations of motion at F (of method paper by its last and its next step), a root on a pin
// or in flight by what keeps it there. So nothing depends on frames.

#include "engine/bake/handover/seam_finder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

// Less than this is rounding [rad, rad/s; m, m/s].
constexpr double kNoJump = 1e-9;

}  // namespace

void SeamFinder::Open(int frame, RegionWalk* walk) {
  is_open_ = false;
  const Animation& animation = context_.animation;
  const bool is_inside = animation.first_frame < frame && frame < animation.last_frame;
  if (!context_.options.seams || !is_inside) return;
  FindBorders(frame);
  if (borders_.empty()) return;
  is_open_ = true;
  frame_ = frame;
  before_ = context_.before;
  left_ = walk->ArrivedWith();
}

void SeamFinder::FindBorders(int frame) {
  borders_.clear();
  const Animation& animation = context_.animation;
  const auto add_regions = [&](const auto& entries, bool begins) {
    for (const auto& [at, r] : entries) {
      borders_.push_back({SeamOf::kRegion, static_cast<int>(r), begins,
                          animation.regions[static_cast<size_t>(r)].joints});
    }
  };
  add_regions(context_.schedule.RegionsUntil(frame), false);
  add_regions(context_.schedule.RegionsFrom(frame), true);
  for (const ActiveHolds::Moved& moved : context_.poses.holds().moved()) {
    if (moved.last_frame != frame) continue;
    borders_.push_back({SeamOf::kHold, static_cast<int>(moved.index), false, moved.joints});
  }
  for (const auto& [at, i] : context_.schedule.HoldsFrom(frame)) {
    Border border{SeamOf::kHold, static_cast<int>(i), true, {}};
    const Figure& figure = *animation.figure;
    for (const GroupIndex g : SolvedJoints(animation.holds[static_cast<size_t>(i)], figure)) {
      const JointGroup& group = figure.group(g);
      for (int h = 0; h < group.size; ++h) border.joints.emplace_back(group.first.value() + h);
    }
    borders_.push_back(std::move(border));
  }
  const auto add_placement = [&](const PlacementSpan* span, bool begins) {
    const auto index = static_cast<int>(span - animation.placements.data());
    borders_.push_back({SeamOf::kPlacement, index, begins, {}});
  };
  const PlacementSpan* span = context_.poses.span();
  if (span && span->last_frame == frame) add_placement(span, false);
  if (const PlacementSpan* next = context_.schedule.PlacementFrom(frame)) add_placement(next, true);
}

void SeamFinder::Cross() {
  if (is_open_) after_ = LimitOf(context_.now);
}

void SeamFinder::Close(const VecX& rates, const MotionAcceleration& after) {
  if (!is_open_) return;
  is_open_ = false;
  after_.qd = rates;
  is_told_.assign(static_cast<size_t>(after_.q.size()), 0);
  for (const Border& border : borders_) AddHinges(border, after);
  // What the root does at the frame it does once; a placement says most about it.
  const auto of_placement =
      std::find_if(borders_.rbegin(), borders_.rend(),
                   [](const Border& border) { return border.of == SeamOf::kPlacement; });
  AddRoot(of_placement == borders_.rend() ? borders_.front() : *of_placement, after);
}

void SeamFinder::AddHinges(const Border& border, const MotionAcceleration& after) {
  for (const JointIndex j : border.joints) {
    const int i = j.value();
    if (is_told_[static_cast<size_t>(i)]) continue;
    is_told_[static_cast<size_t>(i)] = 1;
    Seam seam{border.of, border.index, border.begins, frame_, j};
    seam.angle = NearestTurn(after_.q[i], before_.q[i]) - before_.q[i];
    seam.rate = after_.qd[i] - before_.qd[i];
    seam.acceleration = after.qdd[i] - left_.qdd[i];
    seam.mend = MendOf(border, j, std::max(std::abs(seam.angle), std::abs(seam.rate)));
    context_.recorder.AddSeam(seam);
  }
}

void SeamFinder::AddRoot(const Border& border, const MotionAcceleration& after) {
  Seam seam{border.of, border.index, border.begins, frame_, JointIndex()};
  seam.angle = Eigen::AngleAxisd(after_.X_WR.R * before_.X_WR.R.transpose()).angle();
  seam.rate = (after_.root_w - before_.root_w).norm();
  seam.acceleration = (after.root_alpha - left_.root_alpha).norm();
  seam.distance = (after_.X_WR.p - before_.X_WR.p).norm();
  seam.speed = (after_.root_v - before_.root_v).norm();
  seam.push = (after.root_a - left_.root_a).norm();
  const double jump = std::max({seam.rate, seam.distance, seam.speed});
  seam.mend = MendOf(border, JointIndex(), jump);
  context_.recorder.AddSeam(seam);
}

// What took the rate away, as the handovers of regions, holds and placements deal with it.
SeamMend SeamFinder::MendOf(const Border& border, JointIndex j, double jump) {
  if (jump <= kNoJump) return SeamMend::kNothing;
  CurveSet& curves = context_.poses.curves();
  const auto states_rate = [&](const Key* key) { return key && key->rate; };
  if (!j.is_valid()) {
    const bool is_pinned = border.of == SeamOf::kPlacement && border.begins &&
                           context_.animation.placements[static_cast<size_t>(border.index)].kind ==
                               PlacementKind::kPinned;
    if (is_pinned) return SeamMend::kRest;
    for (int i = 0; i < kNumRootCurves; ++i) {
      if (border.begins && states_rate(curves.root(i).KeyAt(frame_))) return SeamMend::kKeyRate;
    }
    return border.begins ? SeamMend::kRest : SeamMend::kCurve;
  }
  if (border.of == SeamOf::kHold && border.begins) return SeamMend::kRest;
  if (!border.begins) {
    if (!curves.joint(j).HasKeyAfter(frame_)) return SeamMend::kKeyAfter;
    const bool is_limited =
        border.of == SeamOf::kRegion &&
        context_.animation.regions[static_cast<size_t>(border.index)].limit_tangents;
    return is_limited ? SeamMend::kTangents : SeamMend::kCurve;
  }
  const DynamicsRegion& region = context_.animation.regions[static_cast<size_t>(border.index)];
  const auto at = std::lower_bound(region.joints.begin(), region.joints.end(), j);
  if (region.friction[static_cast<size_t>(at - region.joints.begin())] == 0.0) {
    return SeamMend::kFriction;
  }
  return states_rate(curves.joint(j).KeyAt(frame_)) ? SeamMend::kKeyRate : SeamMend::kLimits;
}

}  // namespace hazumi
