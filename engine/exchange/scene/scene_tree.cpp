#include "engine/exchange/scene/scene_tree.h"

#include <Eigen/SVD>

#include "engine/base/utf8.h"

namespace hazumi {
namespace {

constexpr size_t kMostNodes = 100'000;
constexpr int kDeepest = 1'000;

Error Broken(const std::string& file, const std::string& message) {
  return {ErrorCode::kSemantics, file, "nodes",
          message + "; the file is broken or holds no character: export it again"};
}

void MarkMeshes(SceneTree* tree) {
  for (int i = 0; i < tree->size(); ++i) {
    for (const int mesh : tree->node(i).meshes) {
      if (!tree->scene.meshes[static_cast<size_t>(mesh)].is_skinned)
        tree->nodes[static_cast<size_t>(i)].has_rigid_mesh = true;
    }
  }
  for (const SceneMesh& mesh : tree->scene.meshes) {
    for (const SceneMesh::Bind& bind : mesh.binds) {
      if (!bind.weights.empty()) tree->nodes[static_cast<size_t>(bind.node)].is_weighted = true;
    }
  }
}

// A motion of a helper moves the node that it helps.
void MarkAnimated(SceneTree* tree) {
  for (const SceneClip& clip : tree->scene.clips) {
    for (const auto& motion : clip.motions) {
      int node = motion.first;
      while (tree->node(node).is_helper) ++node;  // a node is followed by its first child
      tree->nodes[static_cast<size_t>(node)].is_animated = true;
    }
  }
}

}  // namespace

MatrixParts Decompose(const Eigen::Matrix4d& matrix) {
  MatrixParts parts;
  Mat3 M = matrix.topLeftCorner<3, 3>();
  parts.X.p = matrix.topRightCorner<3, 1>();
  parts.scale = M.colwise().norm().transpose();
  if (M.determinant() < 0.0) parts.scale = -parts.scale;
  for (int k = 0; k < 3; ++k)
    if (std::abs(parts.scale[k]) > 1e-12) M.col(k) /= parts.scale[k];
  parts.is_sheared = !(M.transpose() * M).isIdentity(1e-3);
  const Eigen::JacobiSVD<Mat3> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0.0) U.col(2) = -U.col(2);
  parts.X.R = U * svd.matrixV().transpose();
  // What is 1 but for single precision is 1.
  if ((parts.scale - Vec3::Ones()).cwiseAbs().maxCoeff() < 1e-5) parts.scale = Vec3::Ones();
  return parts;
}

Eigen::Matrix4d Compose(const MatrixParts& parts) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = parts.X.R * parts.scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = parts.X.p;
  return matrix;
}

Result<SceneTree> LookAtScene(const Scene& scene, const std::string& file) {
  SceneTree tree{scene, {}};
  if (scene.nodes.size() > kMostNodes) return Broken(file, "there are more than 100,000");
  std::vector<int> depth;
  for (const SceneNode& node : scene.nodes) {
    const auto parent = static_cast<size_t>(node.parent);
    depth.push_back(node.parent < 0 ? 0 : depth[parent] + 1);
    if (depth.back() > kDeepest) return Broken(file, "they hang more than 1,000 deep");
    TreeNode made;
    made.world =
        node.parent < 0 ? node.local : Eigen::Matrix4d(tree.nodes[parent].world * node.local);
    if (!made.world.allFinite())
      return Broken(file, "the transform of " + ValidUtf8(node.name) + " is not a number");
    tree.nodes.push_back(made);
  }
  MarkMeshes(&tree);
  MarkAnimated(&tree);
  return tree;
}

}  // namespace hazumi
