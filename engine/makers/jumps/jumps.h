#pragma once

// Makes and aims jumps: ordinary keys, pins before and after, and a flight by gravity between them.

#include <optional>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

struct JumpTarget {
  // Landing spot of the middle of the toes [m]; nothing: 80 cm ahead of the figure, or, if a jump
  // is aimed, the spot where its keys have it land.
  std::optional<double> x, y;
  std::optional<double> height;  // rise of the CoM [m]; nothing: as low as it gets there
};

struct JumpReport {
  int first = 0, take_off = 0, landing = 0, last = 0;  // frames
  double height = 0.0;                                 // rise of the CoM as planned [m]
};
struct MadeJump {
  Project project;
  JumpReport report;
};

// Makes a jump from how the figure stands in `now`: crouch, take-off, apex, landing, and back.
// `animation` and `now`: of the project. Errors: kSchema, with what to do instead.
Result<MadeJump> MakeJump(const JumpTarget& target, const MotionFrame& now,
                          const Animation& animation, const Project& project);

// Aims the jump that a frame is in at another spot; its poses stay, earlier or later. `animation`
// and `motion`: of the project. Errors: as MakeJump.
Result<MadeJump> AimJump(const JumpTarget& target, double frame, const Animation& animation,
                         const Motion& motion, const Project& project);

}  // namespace hazumi::makers
