#pragma once

#include "engine/exchange/assimp/channel_sample.h"
#include "engine/exchange/assimp/scene_skeleton.h"

namespace hazumi {

// Turns one animation's channels, which move nodes, into tracks of bones.
class ClipSampler {
 public:
  ClipSampler(const SceneTree& tree, const SceneSkeleton& skeleton);

  // Left out if it moves no bone.
  void AddChannel(const aiNodeAnim& channel, const ChannelSteps& steps);
  const std::vector<const aiNodeAnim*>& channels() const { return used_; }

  // Frames at start + k ticks_per_frame; lists of what stays as at rest are empty.
  std::vector<BoneTrack> Sample(double start_tick, double ticks_per_frame, int num_frames) const;

 private:
  struct Moved {
    const aiNodeAnim* channel = nullptr;
    ChannelSteps steps;
  };
  // The nodes of a bone's chain that make its transform in this animation.
  std::vector<int> ActiveChain(size_t bone) const;
  bool IsMoved(const std::vector<int>& chain) const;
  MatrixParts NodeAt(int node, double tick) const;
  MatrixParts ChainAt(const std::vector<int>& chain, double tick) const;
  BoneTrack SampleBone(size_t bone, double start, double step, int num_frames) const;

  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  std::vector<char> matters_;      // by node: a part of a bone's chain
  std::vector<MatrixParts> rest_;  // by node that matters
  std::vector<Moved> moved_;       // by node
  std::vector<const aiNodeAnim*> used_;
};

}  // namespace hazumi
