#pragma once

#include "engine/exchange/scene/scene_skeleton.h"

namespace hazumi {

// The frame rate on whose frames all the times [s], sorted, lie: `likely` first if it is positive,
// then 30, 24, 25, 60 and other usual ones. 0: none.
double FrameRateOf(const std::vector<double>& times, double likely);

// All clips that move a bone, sampled from the first key (frame 0) to the last, `rate` times a
// second (0: on the frames of the keys). Error: key times or
// values that are none, or too many frames.
Result<std::vector<Clip>> ReadClips(const SceneTree& tree, const SceneSkeleton& skeleton,
                                    double rate, const std::string& file,
                                    std::vector<Warning>* warnings);

}  // namespace hazumi
