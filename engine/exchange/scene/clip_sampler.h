#pragma once

#include "engine/exchange/scene/scene_skeleton.h"

namespace hazumi {

// Turns one clip's motions of nodes into tracks of bones.
class ClipSampler {
 public:
  ClipSampler(const SceneTree& tree, const SceneSkeleton& skeleton);

  // Left out if it moves no bone.
  void Add(int node, const NodeMotion& motion);
  const std::vector<const NodeMotion*>& motions() const { return used_; }

  // Frames at start + k seconds_per_frame; lists of what stays as at rest are empty.
  std::vector<BoneTrack> Sample(double start, double seconds_per_frame, int num_frames) const;

 private:
  struct Times {
    double start, step, slack;  // [s]
    int count;
  };
  // The nodes of a bone's chain that make its transform in this animation.
  std::vector<int> ActiveChain(size_t bone) const;
  bool IsMoved(const std::vector<int>& chain) const;
  Eigen::Matrix4d ProductAt(const std::vector<int>& nodes, double t, double slack) const;
  MatrixParts ChainAt(const std::vector<int>& chain, double t, double slack) const;
  Eigen::Matrix4d NodeAt(int node, double t, double slack) const;
  MatrixParts PartsAt(int node, const NodeValue& value) const;
  BoneTrack SampleBone(size_t bone, const Times& times) const;

  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  std::vector<char> matters_;              // by node: a part of a bone's chain
  std::vector<MatrixParts> rest_;          // by node that matters
  std::vector<const NodeMotion*> motion_;  // by node; null: none
  std::vector<const NodeMotion*> used_;
};

}  // namespace hazumi
