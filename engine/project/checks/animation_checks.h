#pragma once

// Internal. What must hold of an animation between its regions, placements, holds, drives, forces
// and contacts, and warnings of what is odd, but no error.

#include <atomic>
#include <string>
#include <vector>

#include "engine/base/warning.h"
#include "engine/project/checks/checks.h"
#include "engine/project/checks/driven_frames.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Checks all of it. `animation` has its lists in the order of the project, which the places refer
// to. Takes n log n for n of them; ends early, with nothing found, where `cancel` is set.
void CheckAnimation(const Animation& animation, const std::atomic<bool>* cancel,
                    FirstError* errors);

// Parts of CheckAnimation.
// Holds: against each other, placements and regions. `driven`: by all regions. Placements must not
// overlap.
void CheckHolds(const Animation& animation, const DrivenFrames& driven, const SpanSet& gravity,
                const std::atomic<bool>* cancel, FirstError* errors);
// Drives of a region: beside what is known of its joints.
void CheckDrives(const Animation& animation, size_t region, FirstError* errors);
// Forces from outside, and regions.
void CheckForces(const Animation& animation, FirstError* errors);
// Regions and held objects that touch the scene.
void CheckContacts(const Animation& animation, FirstError* errors);

// Warns of placements that are odd.
void WarnAboutPlacements(const Animation& animation, std::vector<Warning>* warnings);
// Warns of forces that nothing feels.
void WarnAboutForces(const Animation& animation, std::vector<Warning>* warnings);
// Warns of contacts that can touch nothing, and of pins that contact leaves no work.
void WarnAboutContacts(const Animation& animation, std::vector<Warning>* warnings);

// "list[3]"
std::string At(const char* list, size_t index);
// Text of a frame.
inline std::string Text(int number) { return std::to_string(number); }

}  // namespace hazumi
