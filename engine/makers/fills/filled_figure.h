#pragma once

// Internal. The figure's motion while it is being filled.

#include <algorithm>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/fills/joint_angles.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Whether the root's keys place the figure in a frame.
inline bool IsKeyed(int frame, const Animation& animation) {
  return std::none_of(animation.placements.begin(), animation.placements.end(),
                      [&](const PlacementSpan& span) {
                        return span.kind != PlacementKind::kKeyed && frame >= span.first_frame &&
                               frame < span.last_frame;
                      });
}

// The motion that the keys give, without dynamics; root and angles are filled in on the way.
class FilledFigure {
 public:
  FilledFigure(const Animation& animation, const Motion& motion)
      : animation_(animation),
        figure_(*animation.figure),
        ws_(figure_),
        first_(motion.frames[0].frame) {
    for (const MotionFrame& frame : motion.frames) frames_.push_back({frame.q, frame.X_WR});
  }

  struct Frame {
    VecX q;
    Pose X_WR;
  };
  Frame& at(int frame) { return frames_[static_cast<size_t>(frame - first_)]; }
  int first() const { return first_; }
  int last() const { return first_ + static_cast<int>(frames_.size()) - 1; }

  // Bodies of a frame: valid until the next call.
  const DynamicsWorkspace& Bodies(int frame) {
    ComputePositions(figure_, at(frame).X_WR, at(frame).q, &ws_);
    return ws_;
  }

  void Take(const FilledJoint& joint, const JointAngles& angles_of) {
    for (size_t t = 0; t < angles_of.by_frame.size(); ++t) {
      const std::vector<double>& angles = angles_of.by_frame[t];
      const int f = joint.first + static_cast<int>(t);
      Frame& frame = at(f);
      if (!joint.group) {
        if (IsKeyed(f, animation_)) frame.X_WR.R = joint.TurnOf(angles);
        continue;
      }
      const int j = figure_.group(*joint.group).first.value();
      for (size_t i = 0; i < angles.size(); ++i) frame.q[j + static_cast<int>(i)] = angles[i];
    }
  }

 private:
  const Animation& animation_;
  const Figure& figure_;
  DynamicsWorkspace ws_;
  int first_;
  std::vector<Frame> frames_;
};

}  // namespace hazumi::makers
