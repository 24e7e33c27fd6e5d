#pragma once

// Internal. What must hold of holds: against each other, placements and regions.

#include <atomic>
#include <string>

#include "engine/project/checks/checks.h"
#include "engine/project/checks/driven_frames.h"

namespace hazumi {

// `driven`: by all regions. Placements must not overlap. As CheckAnimation.
void CheckHolds(const Animation& animation, const DrivenFrames& driven, const SpanSet& gravity,
                const std::atomic<bool>* cancel, FirstError* errors);

// "list[3]"
std::string At(const char* list, size_t index);
// Of a frame.
inline std::string Text(int number) { return std::to_string(number); }

}  // namespace hazumi
