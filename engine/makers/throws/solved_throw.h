#pragma once

// Internal: a throw of an arm, solved.

#include "engine/makers/throws/throws.h"

namespace hazumi::makers {

// Friction of an arm that has let go, and of its hand.
inline constexpr double kThrowFriction = 0.85, kHandFriction = 0.15;

// The part of a throw that is found.
struct SolvedSpan {
  int holder = -1;                  // HolderSpan::number of who throws
  size_t region = 0;                // that moves the arm once it has let go, of Project::regions
  int wind_up = 0;                  // frame from which the arm swings
  int release = 0;                  // frame in which it lets go
  int cleared = 0;                  // last frame of a swing that was found before, or earlier
  std::optional<size_t> goal = {};  // of Project::goals; nothing: one for that release
};

// Keys the swing of the arm from its wind-up with which it lets the object go so that it comes down
// on the spot, past what stands in between; from there on the region moves it. Adds the goal, or
// changes the one that is there. `target` has a style; `animation`: of the project before, for what
// it is built of. Errors: kSchema, with what is in the way; kSemantics, with the distance missed.
Result<MadeThrow> SolveThrow(const ThrowTarget& target, const SolvedSpan& span,
                             const Animation& animation, Project project);

}  // namespace hazumi::makers
