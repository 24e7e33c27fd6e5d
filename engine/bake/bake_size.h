#pragma once

#include <optional>

#include "engine/base/result.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Memory that a motion may take [bytes]. What takes more is refused before it is begun.
inline constexpr double kMostMotionBytes = 1e9;

// Frames that a bake gives at a rate, those at both ends counted.
double NumOutputFrames(const Animation& animation, const FrameRate& rate);

// Memory that a motion at a rate takes [bytes], within a tenth.
double MotionBytes(const Animation& animation, const FrameRate& rate);

// Memory that the logs of exact regions take besides, by which an editor solves nothing twice
// [bytes], where nothing stops or falls.
double LogBytes(const Animation& animation);

// Steps that a bake may take of the paper's method; what takes more is refused before it is begun.
inline constexpr double kMostSteps = 3e6;

// Refuses (kSemantics, naming both numbers) steps so small that there would be too many.
std::optional<Error> CheckSteps(const Animation& animation);

// Refuses (kSemantics, naming both numbers) `bytes` for a motion at a rate if they are too many.
std::optional<Error> CheckBytes(double bytes, const Animation& animation, const FrameRate& rate);

}  // namespace hazumi
