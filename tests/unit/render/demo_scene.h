#pragma once

#include "render/scene/scene.h"

namespace hazumi::render {

// A person of 1.70 m from capsules, walking in place beside a box, with a motion path, markers and
// captions: something to look at and to measure. Frames 0..30.
Scene MakeDemoScene(int frame);

// The same with two ghosts, one before and one after.
Scene MakeGhostScene(int frame);

}  // namespace hazumi::render
