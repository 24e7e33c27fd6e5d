#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What of a motion was computed and how, as a JSON object for a glTF file: {"hazumi": {...}} with
// - `fps`, `first_frame` and `last_frame` of the motion;
// - `regions`: `name`, `method`, `first_frame`, `last_frame` (half open, in the project's frames),
//   `start_s`, `end_s` (in the file's time, which begins at 0), `joints` (hinges) and `friction`
//   (factor per 1/30 s, one for each of them), `root` (its orientation too);
// - `placements`: `kind`, `first_frame`, `last_frame`, `start_s`, `end_s`, `pin`, `landing_pin`
//   (names, where there are any);
// - `events`: `kind`, `time_s` (in the file's time), `joint` (where there is one).
std::string MotionExtras(const Animation& animation, const Motion& motion);

}  // namespace hazumi
