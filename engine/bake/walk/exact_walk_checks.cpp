// What is told where regions begin and end: what cannot be, and what is not as it should be.

#include <algorithm>

#include "engine/bake/walk/begins_inside.h"
#include "engine/bake/walk/contacts_of.h"
#include "engine/bake/walk/exact_walk.h"
#include "engine/bake/walk/own_pairs.h"
#include "engine/base/text.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

// Of constraints that begin to act, and have no time to close them.
std::optional<Error> ExactWalk::CheckGaps() {
  constexpr double kMost = 1e-4, kMostTurn = 0.1 * kDegree;  // [m], [rad]
  if (!driver_ || context_.animation.constraints.empty()) return std::nullopt;
  const FigureMotion& now = context_.now;
  DynamicsWorkspace& ws = context_.poses.workspace();
  ComputePositions(context_.poses.figure(), now.X_WR, now.q, &ws);
  for (const int i : driver_->constraints()) {
    const Constraint& constraint = context_.animation.constraints[i];
    if (constraint.arrive_frames > 0) continue;
    const ConstraintGap gap = GapOf(constraint, context_.poses.figure(), now.X_WR, ws);
    if (gap.distance <= kMost && gap.turn <= kMostTurn) continue;
    const bool is_turn = gap.distance <= kMost;
    return Error{ErrorCode::kSemantics, "", "constraints[" + std::to_string(i) + "]",
                 "the ends of \"" + constraint.name + "\" are " +
                     (is_turn ? FormatShort(gap.turn / kDegree) + " degrees"
                              : FormatShort(1000.0 * gap.distance) + " mm") +
                     " apart in frame " + FormatShort(now.frame) +
                     "; give it arrive_frames to close that, or move one of its ends"};
  }
  return std::nullopt;
}

void ExactWalk::WarnOfInside() {
  const double frame = context_.now.frame;
  const Figure& figure = context_.poses.figure();
  const auto parting = PartingConstraints(context_.animation, driver_->constraints());
  const auto is_parted = [&](int link, int object) {
    return std::any_of(parting.begin(), parting.end(), [&](const Constraint* constraint) {
      return IsParted(link, object, *constraint, figure);
    });
  };
  for (const int r : driver_->regions().indices()) {
    const DynamicsRegion& region = context_.animation.regions[r];
    if (!region.touches_scene || region.first_frame != frame) continue;
    const auto counts = [&](int link, int object) {
      return driver_->regions().Touches(figure.links()[link].joint) && !is_parted(link, object);
    };
    const auto inside =
        TellOfInside(context_.animation, figure, context_.now, counts, &context_.poses.workspace());
    if (!inside) return;
    const std::string place = "regions[" + std::to_string(r) + "]";
    return context_.recorder.AddWarning({place, *inside, region.first_frame});
  }
}

void ExactWalk::WarnOfOverlap() {
  const Figure& figure = context_.poses.figure();
  std::vector<LinkPair> pairs = driver_->regions().own_pairs();
  for (const Constraint* parting : PartingConstraints(context_.animation, driver_->constraints())) {
    std::erase_if(pairs, [&](const LinkPair& pair) { return AreParted(pair, *parting, figure); });
  }
  for (const int r : driver_->regions().indices()) {
    const DynamicsRegion& region = context_.animation.regions[r];
    if (!region.touches_self || region.first_frame != context_.now.frame) continue;
    const auto overlap = TellOfOverlap(pairs, figure, context_.now, &context_.poses.workspace());
    if (!overlap) return;
    const std::string place = "regions[" + std::to_string(r) + "]";
    return context_.recorder.AddWarning({place, *overlap, region.first_frame});
  }
}

// Warns of joints that a drive or a force acts on but that move no mass from this frame on.
void ExactWalk::WarnOfWeightless() {
  const Animation& animation = context_.animation;
  for (const JointIndex joint : driver_->WeightlessJoints()) {
    const int r = driver_->regions().RegionOf(joint);
    if (animation.forces.empty() && animation.regions[r].drives.empty()) continue;
    const int frame = static_cast<int>(context_.now.frame);
    context_.recorder.AddWarning(
        {"regions[" + std::to_string(r) + "]",
         "nothing that joint \"" + context_.poses.figure().joint(joint).name +
             "\" carries has mass from frame " + std::to_string(frame) +
             " on: it goes on as it moves, whatever drives it; give its links mass, let it keep " +
             "what it holds, or leave it out of the region",
         frame});
  }
}

// Of regions that end in `frame`: which springs are too weak to get to where they pull.
void ExactWalk::WarnOfSpentSprings(int frame) {
  constexpr double kNotice = 2.0 * kDegree, kSoon = 1.0;  // [rad], [s]
  const Animation& animation = context_.animation;
  const Figure& figure = context_.poses.figure();
  const auto ends = [&](int r) { return animation.regions[r].last_frame == frame; };
  if (std::none_of(driver_->regions().indices().begin(), driver_->regions().indices().end(), ends))
    return;
  for (const auto& [joint, drive] : driver_->SpentSprings(context_.Seconds(frame))) {
    const int r = driver_->regions().RegionOf(joint);
    if (!ends(r) || drive.lag < kNotice || kSoon * drive.approach > drive.lag) continue;
    const std::string& name =
        drive.is_ball ? figure.group(figure.joint(joint).group).name : figure.joint(joint).name;
    context_.recorder.AddWarning(
        {"regions[" + std::to_string(r) + "].drives",
         "the spring of \"" + name + "\" is too weak: in frame " + std::to_string(frame) +
             " it gives all it can, " + FormatShort(drive.torque) + " of the " +
             FormatShort(drive.wanted) + " N m that it would pull with, and is " +
             FormatShort(drive.lag / kDegree) +
             " degrees from where it pulls to; give it more strength or less to carry",
         frame});
  }
}

}  // namespace hazumi
