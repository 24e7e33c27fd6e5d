#pragma once

#include "engine/timeline/animation.h"

namespace hazumi::test {

// The shipped human, who turns as far as he likes: without limits within reach.
Figure LimberHuman();

// The shipped human upright above a floor, its root so high [m] and turned about y [rad]: let go at
// frame 0, all of it, with friction 0.8, by the method exact; what it touches stops it.
Animation LooseHuman(int frames, double height, double tilt = 0.0);

}  // namespace hazumi::test
