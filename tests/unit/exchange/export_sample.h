#pragma once

// Motions of figures and characters to export, and where their bones are.

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/exchange/character/character.h"
#include "engine/figure/figure.h"

namespace hazumi::test {

// `num_frames` of random poses, 30 a second: the root within metres, angles within the limits.
Motion RandomMotion(const Figure& figure, int num_frames, unsigned seed);

// Poses of the bones in the file's world at a frame of the first clip.
std::vector<Pose> WorldPoses(const Character& character, int frame);

// An upper and a lower arm of a bar with square section, smoothly bent at the elbow, with texture
// coordinates and a PNG texture of four pixels; it waves for 1 s.
Character SkinnedArm();

}  // namespace hazumi::test
