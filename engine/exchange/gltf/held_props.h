#pragma once

// Held objects of a motion for a glTF file.

#include <vector>

#include "engine/bake/motion.h"
#include "engine/exchange/character/axes.h"
#include "engine/exchange/gltf/gltf_prop.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Each held object of the motion as a prop, its colour or its mesh's materials and textures added
// to the character's; each part of a mesh is a prop of its own. What is held
// throughout is carried by its holder's bone, of those that CharacterFromMotion makes; what is let
// go, or was, moves by itself, frame by frame, while it is held too: no node of glTF changes its
// parent. None of a motion without frames.
std::vector<GltfProp> HeldProps(const Animation& animation, const Motion& motion,
                                const FileAxes& axes, Character* character);

}  // namespace hazumi
