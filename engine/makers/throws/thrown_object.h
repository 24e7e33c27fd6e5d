#pragma once

// Internal. What becomes of an object that is thrown: it flies, comes down and lies there.

#include "engine/makers/throws/throw_path.h"
#include "engine/project/edits/holders.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Lets an object come down on the end of its path, after its keys of that flight before, and lie
// there; makes the project long enough to see that. `release`: frame in which `thrower` lets it go.
// Returns the first frame in which it lies there.
int LieDown(const ThrowPath& path, const Vec3& spot, const HolderSpan& thrower, int release,
            const Animation& animation, int object, Project* project);

}  // namespace hazumi::makers
