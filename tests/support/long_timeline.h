#pragma once

#include "engine/timeline/animation.h"

namespace hazumi::test {

// A scene that goes on: the human shifts its weight from foot to foot, pinned by one and then the
// other, with a key on every moving joint each ten frames, and swings its arms in exact regions of
// ten frames. The regions are spread evenly over frames 0 to num_frames.
Animation LongTimeline(int num_frames, int num_regions);

}  // namespace hazumi::test
