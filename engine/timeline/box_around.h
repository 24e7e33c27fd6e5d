#pragma once

#include "engine/timeline/scene_object.h"

namespace hazumi {

// Whole edges of the box around a held object's shape, along its own axes [m].
Vec3 BoxAround(const HeldObject& object);

// Meshes about the middle of the box around them, which becomes one of this size; a side without
// length stays so. All binds are to the thing's own frame.
Skin Stretched(const Skin& mesh, const Vec3& size);

}  // namespace hazumi
