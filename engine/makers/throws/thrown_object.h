#pragma once

// Internal. What becomes of an object that is thrown: it flies, comes down and lies there.

#include "engine/makers/throws/throw_path.h"
#include "engine/project/edits/holders.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Lets an object that `thrower` lets go come down on the end of its path and lie there, until
// somebody takes it; keys of its flight before are taken away. Makes the project long enough to see
// that. Returns the first frame in which it lies there.
int LieDown(const ThrowPath& path, const Vec3& spot, const HolderSpan& thrower,
            const Animation& animation, int object, Project* project);

}  // namespace hazumi::makers
