#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"

namespace hazumi {

// Where a figure's bodies are in the frames of a motion: what ComputePositions finds, centres of
// mass aside, without finding it twice.
class PlacedFrames {
 public:
  PlacedFrames(const Figure& figure, size_t num_frames) : stride_(figure.num_joints() + 1) {
    placed_.reserve(stride_ * num_frames);
  }

  // Frame by frame, in order.
  void Add(const DynamicsWorkspace& ws) {
    for (const BodyScratch& body : ws.bodies) placed_.push_back({body.R, body.p, body.axis});
  }
  // Fills R, p, axis.
  void Get(size_t frame, DynamicsWorkspace* ws) const {
    const Placed* placed = &placed_[frame * stride_];
    for (size_t i = 0; i < stride_; ++i) {
      BodyScratch& body = ws->bodies[i];
      body.R = placed[i].R;
      body.p = placed[i].p;
      body.axis = placed[i].axis;
    }
  }

 private:
  struct Placed {
    Mat3 R;
    Vec3 p, axis;
  };
  size_t stride_;               // bodies
  std::vector<Placed> placed_;  // by frame and body
};

}  // namespace hazumi
