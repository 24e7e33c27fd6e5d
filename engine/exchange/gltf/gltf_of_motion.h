#pragma once

// Parts of a motion, beside its character, for a glTF file: held objects and extras.

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/exchange/character/axes.h"
#include "engine/exchange/gltf/gltf_write.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Each held object of the motion as a prop, its colour or its mesh's materials and textures added
// to the character's; each part of a mesh is a prop of its own. What is held
// throughout is carried by its holder's bone, of those that CharacterFromMotion makes; what is let
// go, or was, moves by itself, frame by frame, while it is held too: no node of glTF changes its
// parent. None of a motion without frames.
std::vector<GltfProp> HeldProps(const Animation& animation, const Motion& motion,
                                const FileAxes& axes, Character* character);

// What of a motion was computed and how, as a JSON object for a glTF file: {"hazumi": {...}} with
// - `fps`, `first_frame` and `last_frame` of the motion;
// - `regions`: `name`, `method`, `first_frame`, `last_frame` (half open, in the project's frames),
//   `start_s`, `end_s` (in the file's time, which begins at 0), `joints` (hinges) and `friction`
//   (factor per 1/30 s, one for each of them), `root` (its orientation too);
// - `placements`: `kind`, `first_frame`, `last_frame`, `start_s`, `end_s`, `pin`, `landing_pin`
//   (names, where there are any);
// - `events`: `kind`, `time_s` (in the file's time), `joint` (where there is one).
std::string MotionExtras(const Animation& animation, const Motion& motion);

}  // namespace hazumi
