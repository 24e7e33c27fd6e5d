#pragma once

// How Collada says that nodes move, which assimp 5.2.5 passes on at keys alone: a node's transform
// is the product of its elements, translate, rotate, scale and matrix, in their order; numbers of
// them follow curves that step, are straight, or are Bezier curves of time and value; matrices
// step, or go straight by translation, rotation and scale. [Collada 1.4.1, "Curve interpolation"]

#include <string_view>

#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Replaces the motions of a scene that assimp read from these bytes by those of the curves. What
// cannot be told apart, or is of another kind, stays as assimp has it: nodes of one name, several
// clips, elements such as lookat. Warns of these, and of bytes that are no XML.
void TakeColladaMotions(std::string_view bytes, Scene* scene);

}  // namespace hazumi
