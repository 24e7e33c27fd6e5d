#include "engine/analysis/held_turn.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/effort.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi {

namespace {

constexpr double kLeastMoment = 0.02;  // share of the weight on an arm as long as the figure
constexpr int kMarginFrames = 2;       // frames that accelerations and touch-downs depend on

bool IsByGravity(const Animation& animation, double frame) {
  return std::any_of(
      animation.placements.begin(), animation.placements.end(), [&](const PlacementSpan& span) {
        return span.kind == PlacementKind::kGravity &&
               HasInstant(span.first_frame, span.last_frame, frame, animation.last_frame);
      });
}

bool IsRootFree(const Animation& animation, double frame) {
  return std::any_of(
      animation.regions.begin(), animation.regions.end(), [&](const DynamicsRegion& region) {
        return region.root &&
               HasInstant(region.first_frame, region.last_frame, frame, animation.last_frame);
      });
}

bool IsMoved(JointIndex j, const DynamicsRegion& region, const Figure& figure) {
  return std::any_of(region.joints.begin(), region.joints.end(),
                     [&](JointIndex moved) { return figure.IsBeyond(j, moved); });
}

// Returns whether the region moves more than half of the mass.
bool MovesMost(const DynamicsRegion& region, const Figure& figure) {
  double mass = 0.0;
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (IsMoved(JointIndex(j), region, figure)) mass += figure.body(JointIndex(j)).mass;
  }
  return mass > 0.5 * figure.total_mass();
}

// Longest distance from the root to the end of a link [m].
double ReachOf(const Figure& figure, const MotionFrame& frame) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  double reach = 0.0;
  for (const Link& link : figure.links()) {
    const BodyScratch& body = ws.body(link.joint);
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      reach = std::max(reach, (body.p + body.R * end - frame.X_WR.p).norm());
    }
  }
  return reach;
}

// Frames of a region, and some frames before and after it.
class RegionFrames {
 public:
  RegionFrames(const Animation& animation, const Motion& motion, size_t region)
      : animation_(animation), region_(animation.regions[region]) {
    part_.rate = motion.rate;
    const double first = OutputAt(region_.first_frame, motion) - kMarginFrames,
                 last = OutputAt(region_.last_frame, motion) + kMarginFrames;
    for (const MotionFrame& frame : motion.frames) {
      if (frame.frame >= first && frame.frame <= last) part_.frames.push_back(frame);
    }
  }

  HeldTurn Find() const {
    HeldTurn turn;
    if (part_.frames.empty()) return turn;
    const Effort effort = EffortOf(animation_, part_);
    const bool moves_most = MovesMost(region_, *animation_.figure);
    for (size_t i = 0; i < part_.frames.size(); ++i) {
      const double moment = effort.frames[i].from_nowhere.moment.norm();
      if (moment <= turn.moment || !LetsGo(part_.frames[i], moves_most)) continue;
      turn.moment = moment;
      turn.frame = static_cast<int>(std::lround(FrameOf(part_.frames[i])));
    }
    return turn;
  }

  double LeastNoted() const {
    const Figure& figure = *animation_.figure;
    const double weight = figure.total_mass() * std::max(animation_.gravity, 1.0);
    return kLeastMoment * weight *
           (part_.frames.empty() ? 1.0 : ReachOf(figure, part_.frames.front()));
  }

 private:
  double OutputAt(int frame, const Motion& motion) const {
    return FrameAtRate(frame, animation_.rate, motion.rate);
  }
  // Converts to frames of the animation.
  double FrameOf(const MotionFrame& frame) const {
    return FrameAtRate(frame.frame, part_.rate, animation_.rate);
  }

  bool LetsGo(const MotionFrame& frame, bool moves_most) const {
    const double at = FrameOf(frame);
    if (!HasInstant(region_.first_frame, region_.last_frame, at, animation_.last_frame))
      return false;
    if (!IsByGravity(animation_, at) || IsRootFree(animation_, at)) return false;
    const Figure& figure = *animation_.figure;
    if (!frame.pinned) return moves_most;
    return IsMoved(figure.group(*frame.pinned).last(), region_, figure);
  }

  const Animation& animation_;
  const DynamicsRegion& region_;
  Motion part_;
};

}  // namespace

bool MayHoldTurn(const DynamicsRegion& region, const Animation& animation) {
  if (region.root || !region.touches_scene || region.joints.empty()) return false;
  return std::any_of(
      animation.placements.begin(), animation.placements.end(), [&](const PlacementSpan& span) {
        return span.kind == PlacementKind::kGravity && span.first_frame < region.last_frame &&
               region.first_frame < span.last_frame;
      });
}

bool MayHoldTurns(const Animation& animation) {
  return std::any_of(animation.regions.begin(), animation.regions.end(),
                     [&](const DynamicsRegion& region) { return MayHoldTurn(region, animation); });
}

std::vector<HeldTurn> FindHeldTurns(const Animation& animation, const Motion& motion) {
  std::vector<HeldTurn> turns;
  for (size_t r = 0; r < animation.regions.size(); ++r) {
    if (!MayHoldTurn(animation.regions[r], animation)) continue;
    const RegionFrames frames(animation, motion, r);
    HeldTurn turn = frames.Find();
    turn.region = r;
    if (turn.moment > frames.LeastNoted()) turns.push_back(turn);
  }
  return turns;
}

std::vector<Warning> WarningsOf(const std::vector<HeldTurn>& turns, const Animation& animation) {
  std::vector<Warning> warnings;
  warnings.reserve(turns.size());
  for (const HeldTurn& turn : turns) {
    warnings.push_back(
        {"regions[" + std::to_string(turn.region) + "].joints",
         "gravity and contacts move the figure, but the root's turn stays with its keys: nothing "
         "supplies the " +
             FormatShort(turn.moment) + " N m that this takes in frame " +
             std::to_string(turn.frame) + "; add the root \"" + animation.figure->root_name() +
             "\" to the region's joints",
         turn.frame});
  }
  return warnings;
}

}  // namespace hazumi
