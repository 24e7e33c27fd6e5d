#pragma once

// Figures let go by a bake: animations that are one dynamics region, and what every outcome of a
// bake must satisfy.

#include "engine/bake/bake.h"
#include "engine/timeline/animation.h"

namespace hazumi::test {

// All joints of the figure in one region without friction, from this state at frame 0 to the last
// frame, at 30 frames a second.
Animation Released(Figure figure, const VecX& q, const VecX& qd, int frames, Method method);
void SetMethod(Animation* animation, Method method);
void SetTolerance(Animation* animation, double radians);
void SetStep(Animation* animation, double seconds);

// True if every number of every frame and of every event is finite.
bool IsFinite(const Motion& motion);
// True if a failed bake says which joint, after which frame, and why.
bool SaysJointFrameAndCause(const Error& error);
// Bakes, and requires an error or a motion of at most a million evaluations of the equations of
// motion. A bake limits its own work; CTest ends one that hangs.
Result<Motion> BakeSoundly(const Animation& animation);
// Bakes, and demands finite frames. Empty if there are none.
Motion BakeFinite(const Animation& animation);

// EnergyOf the last frame over that of the first, changes measured by EnergyScale of the first.
double EnergyGain(const Animation& animation, const Motion& motion);

}  // namespace hazumi::test
