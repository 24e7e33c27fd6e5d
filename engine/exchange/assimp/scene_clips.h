#pragma once

#include <unordered_set>

#include "engine/exchange/assimp/scene_skeleton.h"

namespace hazumi {

// How keys of a channel are joined where assimp does not say: by "animation index/node/path", such
// as "0/hips/rotation".
using SteppedChannels = std::unordered_set<std::string>;

// The frame rate on whose frames all the times [s], sorted, lie: `likely` first if it is positive,
// then 30, 24, 25, 60 and other usual ones. 0: none.
double FrameRateOf(const std::vector<double>& times, double likely);

// All animations that move a bone, sampled from the first key (frame 0) to the last.
// `ticks_are_frames`: a tick is a frame of the rate that the file states (FBX). Error: key times or
// values that are none, or too many frames.
Result<std::vector<Clip>> ReadClips(const aiScene& scene, const SceneTree& tree,
                                    const SceneSkeleton& skeleton, bool ticks_are_frames,
                                    const SteppedChannels& stepped, const std::string& file,
                                    std::vector<Warning>* warnings);

}  // namespace hazumi
