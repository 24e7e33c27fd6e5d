#pragma once

// A scene's nodes at rest, and which of them something hangs on or moves.

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Translation, rotation and scale of a matrix that is T R S.
struct MatrixParts {
  Pose X;
  Vec3 scale = Vec3::Ones();
  bool is_sheared = false;  // it was not; R is the nearest rotation
};
MatrixParts Decompose(const Eigen::Matrix4d& matrix);
Eigen::Matrix4d Compose(const MatrixParts& parts);

struct TreeNode {
  Eigen::Matrix4d world;  // at rest
  bool has_rigid_mesh = false, is_weighted = false, is_animated = false;
};

struct SceneTree {
  const Scene& scene;
  std::vector<TreeNode> nodes;  // by node of the scene

  int size() const { return static_cast<int>(nodes.size()); }
  const SceneNode& node(int i) const { return scene.nodes[static_cast<size_t>(i)]; }
  const TreeNode& operator[](int i) const { return nodes[static_cast<size_t>(i)]; }
};

// Error: too many or too deep, numbers that are none. The scene has to outlive the tree.
Result<SceneTree> LookAtScene(const Scene& scene, const std::string& file);

}  // namespace hazumi
