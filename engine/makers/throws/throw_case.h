#pragma once

// Internal: a throw in a project, and its new speeds.

#include <memory>
#include <optional>
#include <vector>

#include "engine/makers/throws/throws.h"

namespace hazumi::makers {

// A throw: what is thrown, and by what.
struct ThrowCase {
  int object = 0;   // of the project's held objects
  int holder = -1;  // of the object's later holders, who throws it; -1: who has it at first
  int release = 0;  // the frame in which it is let go
  int region = 0;   // of the project's, which moves what holds it
  // Hinges of the region that carry the holder and whose start rates are free, the nearest to the
  // root first.
  std::vector<JointIndex> hinges;
  // The keys before the region are of the throw too: their curves follow its rates.
  bool has_backswing = false;
};

// Swings a throw that was made anew, as if it were made for this target, and sets has_backswing.
// Leaves any other throw as it is.
void SwingAnew(const ThrowTarget& target, const Animation& animation, const Motion& motion,
               ThrowCase* of, Project* project);

// Has the region start as fast as it must, and the object lie on the spot after it came down. Finds
// the hinges of the case. Errors: those of ThrowAim, and what would help.
Result<ThrowReport> ThrowTo(const ThrowTarget& target, ThrowCase of,
                            std::shared_ptr<const Figure> figure, Project* project);

}  // namespace hazumi::makers
