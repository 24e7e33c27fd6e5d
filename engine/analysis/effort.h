#pragma once

// What a motion asks of muscles and of the ground.

#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/contact_forces.h"
#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct EffortOptions {
  double friction = kGroundFriction;
  // Of captures, which are filtered before they are differentiated [Hz].
  double cutoff = 6.0;
};

// Something outside that pushes the figure in a frame.
struct EffortContact {
  JointIndex joint;           // whose body is pushed; invalid: the root's
  bool is_grip = false;       // a hand that can pull; else something that the body lies on
  Vec3 p = Vec3::Zero();      // world [m]
  Vec3 force = Vec3::Zero();  // on the figure [N]
};

struct FrameEffort {
  VecX tau;  // by JointIndex, about the hinge's axis, on the body beyond it [N m]
  // By JointIndex: |tau| as a share of the hinge's strength in that direction, at its angle and
  // rate; negative: its strength is not known. 0 where a stop gives it.
  VecX share;
  std::vector<JointIndex> least;  // hinges whose share is of the least strength there is
  std::vector<EffortContact> contacts;
  // What no sole, hand or other contact can supply: force on the root, and moment about its origin,
  // world axes. In a flight it is what keys ask for against the laws of motion.
  Wrench from_nowhere;
};

struct Effort {
  std::vector<FrameEffort> frames;  // as those of the motion
  bool is_filtered = false;
  double cutoff = 0.0;  // [Hz]
};

// Whether a clip has a key on nearly every frame, as captures have.
bool IsCapture(const Animation& animation);

// One entry a frame. Accelerations are those of the bake (BakeOptions::accelerations: exact, from
// the right); of a motion without them those of frame_accelerations.h; of captures, differences of
// the filtered motion. What is held counts as part of its holder. Gravity, the weight of what is
// held, what constraints and regions with contacts are pushed with, and wind and pulls, on all
// links while they act, are the known forces from outside.
Effort EffortOf(const Animation& animation, const Motion& motion,
                const EffortOptions& options = {});

}  // namespace hazumi
