#pragma once

// Gives a flight that keys have to gravity. The equations are in flight_arc.cpp.

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Frames of a flight: the figure leaves the ground on the first, or is in the air on it already,
// and lands on the last, or is in the air on it still.
struct FlightSpan {
  int first = 0, last = 0;
};

struct FlightReport {
  int by_gravity = 0;  // first frame that gravity places
  Vec3 root_velocity;  // on that frame, world [m/s]
  int trials = 0;      // bakes until it landed where the keys have it
  double work = 0.0;   // of the trials (Work)
};
struct MadeFlight {
  Project project;
  FlightReport report;
};

// Returns the project with a flight by gravity whose take-off is so fast that it lands where the
// keys have it. `animation` and `motion`: of the project, up to the frame after the flight. Errors:
// kSchema, with what is in the way.
Result<MadeFlight> MakeFlight(const FlightSpan& span, const Project& project,
                              const Animation& animation, const Motion& motion);
// Bakes the project as far as it needs.
Result<MadeFlight> MakeFlight(const FlightSpan& span, const Project& project);

}  // namespace hazumi::makers
