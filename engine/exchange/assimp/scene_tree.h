#pragma once

// A scene's nodes in a row, and which of them are bones.

#include <assimp/scene.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

Eigen::Matrix4d ToMatrix(const aiMatrix4x4& matrix);

// Translation, rotation and scale of a matrix that is T R S.
struct MatrixParts {
  Pose X;
  Vec3 scale = Vec3::Ones();
  bool is_sheared = false;  // it was not; R is the nearest rotation
};
MatrixParts Decompose(const Eigen::Matrix4d& matrix);

struct SceneNode {
  const aiNode* node = nullptr;
  int parent = -1;
  bool is_helper = false;        // assimp's own, a part of the transform of the FBX node below it
  Eigen::Matrix4d local, world;  // at rest
  bool has_rigid_mesh = false, is_weighted = false, is_animated = false;
  bool is_view = false;  // a camera or a light, on which nothing hangs
};

// Parents come before children; 0 is the scene's root.
struct SceneTree {
  std::vector<SceneNode> nodes;
  std::unordered_map<std::string, int> by_name;  // the first of a name

  int Find(const aiString& name) const;  // -1: none
};

// Error: too many or too deep, numbers that are none.
Result<SceneTree> FlattenScene(const aiScene& scene, const std::string& file);

}  // namespace hazumi
