#pragma once

#include <vector>

#include "engine/placement/figure_motion.h"
#include "engine/timeline/animation.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

// Which limit to take at an instant where curves may break.
enum class Side { kBefore, kAfter };

// All curves of an animation while it is baked.
class CurveSet {
 public:
  explicit CurveSet(const Animation& animation);

  CurveTrack& joint(JointIndex j) { return joints_[j.value()]; }
  CurveTrack& root(int curve) { return root_[curve]; }

  // The pieces of all curves that lead to a frame, and to go on from them: of the joints, then of
  // the root.
  std::vector<CurveTrack::Piece> PiecesBefore(double frame);
  void Restart(const std::vector<CurveTrack::Piece>& pieces);

  // Joint angles, rates and accelerations; entries with skip[j] set are left alone.
  void SampleJoints(double frame, Side side, const std::vector<char>& skip, FigureMotion* motion);
  // Orientation of the root and its rates.
  void SampleRootOrientation(double frame, Side side, FigureMotion* motion);
  // Position of the root and its rates.
  void SampleRootPosition(double frame, Side side, FigureMotion* motion);
  // The root's three hinge angles, z y x.
  RootAngles RootAnglesAt(double frame, Side side);

 private:
  static CurveSample Sample(CurveTrack* track, double frame, Side side) {
    return side == Side::kBefore ? track->Before(frame) : track->At(frame);
  }

  std::vector<CurveTrack> joints_, root_;
};

}  // namespace hazumi
