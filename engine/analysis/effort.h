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

// Contact force on the figure in a frame.
struct EffortContact {
  JointIndex joint;           // joint of the body in contact; invalid: the root's body
  bool is_grip = false;       // hand that can pull; else a contact that can only push
  Vec3 p = Vec3::Zero();      // world [m]
  Vec3 force = Vec3::Zero();  // acts on the figure [N]
};

struct FrameEffort {
  VecX tau;  // by JointIndex, about the hinge's axis, on the body beyond it [N m]
  // By JointIndex: |tau| as a share of the hinge's strength in that direction, at its angle and
  // rate; negative: its strength is not known. 0 where a stop gives it.
  VecX share;
  std::vector<JointIndex> least;  // hinges whose share is of the least strength there is
  std::vector<EffortContact> contacts;
  // Residual wrench, which no contact can supply: force on the root, and moment about its origin,
  // world axes. In flight it is the deviation of the keys from ballistic motion.
  Wrench from_nowhere;
};

struct Effort {
  std::vector<FrameEffort> frames;  // as those of the motion
  bool is_filtered = false;
  double cutoff = 0.0;  // [Hz]
};

// Whether a clip has a key on nearly every frame, as captures have.
bool IsCapture(const Animation& animation);

// Returns one entry per frame. The accelerations are those of the bake (BakeOptions::accelerations:
// exact, right-sided). A motion without accelerations uses AccelerationAt; a capture uses
// differences of the filtered motion. A held object counts as part of its holder. The known
// external forces are gravity, the weight of held objects, the forces of constraints and of regions
// with contacts, wind, and pulls on links while they act.
Effort EffortOf(const Animation& animation, const Motion& motion,
                const EffortOptions& options = {});

// The largest torque and the largest share of a strength, with hinge and frame, what comes from
// nowhere, and how accelerations were found: a line each.
std::vector<std::string> EffortReport(const Animation& animation, const Motion& motion,
                                      const Effort& effort);
// One line of it: the largest share of a strength, or where none is known the largest torque. None
// of a motion without frames.
std::vector<std::string> BriefEffortReport(const Animation& animation, const Motion& motion,
                                           const Effort& effort);

}  // namespace hazumi
