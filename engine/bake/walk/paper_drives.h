#pragma once

#include <map>
#include <memory>
#include <vector>

#include "engine/bake/walk/drive_curves.h"
#include "engine/bake/walk/feed_forward.h"
#include "engine/region/ball_axes.h"
#include "engine/region/forces/spring_drive.h"

namespace hazumi {

// The torques T that drives give the hinges of active regions at the start of a step
// [Arai 2.1 (2)].
class PaperDrives {
 public:
  explicit PaperDrives(BakeContext* context) : context_(*context), curves_(context) {}

  void SetRegions(const std::vector<int>& regions);
  bool empty() const { return springs_.empty(); }
  // By JointIndex [N m], of a figure in that motion.
  VecX TorquesAt(const FigureMotion& motion);

 private:
  struct Ball {
    BallAxes axes;
    size_t entry;  // of the first hinge
  };
  // What the springs of the entries pull to, and of what else regions move the keys.
  FigureMotion KeyedAt(const FigureMotion& motion);
  SpringNow Now(size_t entry, double frame);

  BakeContext& context_;
  DriveCurves curves_;
  std::vector<Spring> springs_;           // by entry of the curves
  std::map<JointIndex, Ball> balls_;      // by first hinge: with a spring
  std::unique_ptr<FeedForward> forward_;  // where a spring asks for it
};

}  // namespace hazumi
