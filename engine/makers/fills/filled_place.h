#pragma once

// Internal. A curve of the root's place between its keys.

#include <vector>

#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

struct FilledPlace {
  int first = 0;
  std::vector<double> values;  // by frame from `first` on [m]; empty: not filled
};

// Natural cubic from the first key in the fill to the last one; it arrives and leaves as joints do.
// Nothing if there are fewer than two keys.
FilledPlace FilledPlaceOf(const Keys& keys, const ProjectFill& fill, const Animation& animation);

}  // namespace hazumi::makers
