#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"
#include "render/scene/camera.h"

namespace hazumi::render {

// A camera that sees the whole motion, what is thrown in it and the boxes beside it, from a named
// side: front (looking along -x), back, left, right, top or three-quarter. `aspect` is width over
// height.
Camera FrameMotion(const Animation& animation, const Motion& motion, const std::string& side,
                   double aspect);

}  // namespace hazumi::render
