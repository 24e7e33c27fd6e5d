#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// A seam as a JSON object; its fields are listed in README.md beside this file.
std::string SeamToJson(const Animation& animation, const Seam& seam);

}  // namespace hazumi
