#pragma once

#include "engine/exchange/scene/scene_tree.h"

namespace hazumi {

// The bones that a scene's nodes make.
struct SceneSkeleton {
  std::string chosen;               // of several characters the one that is taken
  std::vector<std::string> others;  // and the others
  std::vector<Bone> bones;
  // By bone: the nodes whose transforms, multiplied in this order, take the bone to its parent. The
  // last is the bone's own; before it are FBX helpers and, for the first bone, all that lies above.
  std::vector<std::vector<int>> chains;
  std::vector<int> bone_of_node;  // -1: none
  // By node: beside the skeleton, or hangs on what is.
  std::vector<char> is_apart;
  double size = 1.0;  // distance of the farthest bone from the origin

  // The bone that a node moves with: its own or that of an ancestor; the first if there is none.
  int Carrier(const SceneTree& tree, int node) const;
  // A bone's frame at rest in the scene's, scales included.
  const Eigen::Matrix4d& World(const SceneTree& tree, int bone) const;
};

// Which nodes are bones: bone_selection.h. What is beside the skeleton, such as a ball that was
// thrown or a camera, is no part of it. Warns of what is left out, renamed, scaled or sheared.
// `wanted`: the
// character to take, by name; empty: bone_selection.h says which. Error: there are no bones, or
// none of that name.
Result<SceneSkeleton> FindSkeleton(const SceneTree& tree, const std::string& wanted,
                                   const std::string& file, std::vector<Warning>* warnings);

}  // namespace hazumi
