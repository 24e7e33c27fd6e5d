#pragma once

// Internal: a flight between two pins, as its events tell it.

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Puts the events of all stretches in order of time. A flight that gravity takes over in the air
// takes off where its pin ends, a few frames before. One that a pin ends lands there for good: no
// take-off follows in the same instant.
void TellFlights(const Animation& animation, Motion* motion);

}  // namespace hazumi
