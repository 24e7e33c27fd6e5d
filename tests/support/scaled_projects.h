#pragma once

#include <string>
#include <vector>

#include "engine/project/project.h"

namespace hazumi::test {

// Projects of which one thing grows and all else stays as small as it may.
struct ScaledProject {
  Project project;
  // A key somewhere in the middle, which can be given another value.
  std::string curve;
  double frame = 0.0;
};

// frames      of the human's arms, with a key each ten frames
// keys        of the human's arms, one each frame
// joints      of a tree whose rods have two rods at their ends, all free for a frame
// limbs       of one joint on one body, all free for a frame
// regions     of the human's wrist, one after the other
// placements  of the human, on one foot and on the other
// holds       of the human's foot, one after the other
const std::vector<std::string>& ScaledKinds();
ScaledProject MakeScaled(const std::string& kind, int count);

}  // namespace hazumi::test
