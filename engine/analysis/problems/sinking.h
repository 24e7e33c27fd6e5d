#pragma once

// Frames in which keys or a pin put the figure into the scene.

#include <memory>
#include <optional>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/dynamics/workspace.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Consecutive frames in which the figure is deep inside an object of the scene.
struct Sinking {
  int first = 0, last = 0;  // frames, both inclusive
  int deepest = 0;          // frame
  double depth = 0.0;       // there [m], more than kDeep
  GroupIndex joint;         // nearest to the deepest place
};

// Finds them, a few frames at a time. Excludes what gravity places, which touches by itself, and
// objects that a constraint ties to the figure. A frame is evaluated again only if its pose has
// changed.
class SinkingFinder {
 public:
  static constexpr double kDeep = 0.01;  // smallest depth that is reported [m]

  // Evaluates at most `most` frames that are not known yet. Returns whether all are known then.
  bool Look(const Animation& animation, const Motion& motion, int most);
  // Among the frames known so far.
  const std::vector<Sinking>& sinkings() const { return sinkings_; }

 private:
  struct Known {
    VecX q;
    Pose X_WR;
    double depth = 0.0;  // [m]; 0 if the figure is inside nothing
    GroupIndex joint;
  };
  void Begin(const Animation& animation, size_t num_frames);
  Known LookAt(const MotionFrame& frame, DynamicsWorkspace* ws) const;
  void Collect(const std::vector<PlacementSpan>& placements, int first_frame);

  std::shared_ptr<const Figure> figure_;
  std::vector<SceneObject> scene_;
  std::vector<std::optional<Known>> known_;  // by frame, from the animation's first one
  std::vector<Sinking> sinkings_;
};

}  // namespace hazumi
