#include "engine/exchange/assimp/scene_tree.h"

#include <Eigen/SVD>
#include <cstring>

namespace hazumi {
namespace {

constexpr size_t kMostNodes = 100'000;
constexpr int kDeepest = 1'000;

Error Broken(const std::string& file, const std::string& message) {
  return {ErrorCode::kSemantics, file, "nodes",
          message + "; the file is broken or holds no character: export it again"};
}

SceneNode MakeNode(const aiNode* node, int parent, const SceneTree& tree) {
  SceneNode made;
  made.node = node;
  made.parent = parent;
  made.is_helper = std::strstr(node->mName.C_Str(), "_$AssimpFbx$_") && node->mNumChildren > 0;
  made.local = ToMatrix(node->mTransformation);
  made.world = parent < 0
                   ? made.local
                   : Eigen::Matrix4d(tree.nodes[static_cast<size_t>(parent)].world * made.local);
  return made;
}

void MarkMeshes(const aiScene& scene, SceneTree* tree) {
  for (SceneNode& node : tree->nodes) {
    for (unsigned i = 0; i < node.node->mNumMeshes; ++i) {
      const unsigned mesh = node.node->mMeshes[i];
      if (mesh < scene.mNumMeshes && !scene.mMeshes[mesh]->HasBones()) node.has_rigid_mesh = true;
    }
  }
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b) {
      const aiBone& bone = *scene.mMeshes[m]->mBones[b];
      const int node = tree->Find(bone.mName);
      // assimp lists bones without weight with a weight of 0.
      for (unsigned w = 0; node >= 0 && w < bone.mNumWeights; ++w) {
        if (bone.mWeights[w].mWeight > 0.0f)
          tree->nodes[static_cast<size_t>(node)].is_weighted = true;
      }
    }
  }
}

// A channel of a helper moves the node that it helps.
void MarkAnimated(const aiScene& scene, SceneTree* tree) {
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c) {
      int node = tree->Find(scene.mAnimations[a]->mChannels[c]->mNodeName);
      // A node is followed by its first child.
      while (node >= 0 && tree->nodes[static_cast<size_t>(node)].is_helper) ++node;
      if (node >= 0) tree->nodes[static_cast<size_t>(node)].is_animated = true;
    }
  }
}

void MarkViews(const aiScene& scene, SceneTree* tree) {
  const auto mark = [&](const aiString& name) {
    const int node = tree->Find(name);
    if (node >= 0 && tree->nodes[static_cast<size_t>(node)].node->mNumChildren == 0)
      tree->nodes[static_cast<size_t>(node)].is_view = true;
  };
  for (unsigned i = 0; i < scene.mNumCameras; ++i) mark(scene.mCameras[i]->mName);
  for (unsigned i = 0; i < scene.mNumLights; ++i) mark(scene.mLights[i]->mName);
}

}  // namespace

Eigen::Matrix4d ToMatrix(const aiMatrix4x4& m) {
  Eigen::Matrix4d result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return result;
}

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

int SceneTree::Find(const aiString& name) const {
  const auto found = by_name.find(name.C_Str());
  return found == by_name.end() ? -1 : found->second;
}

Result<SceneTree> FlattenScene(const aiScene& scene, const std::string& file) {
  struct Waiting {
    const aiNode* node;
    int parent, depth;
  };
  SceneTree tree;
  std::vector<Waiting> waiting;
  if (scene.mRootNode) waiting.push_back({scene.mRootNode, -1, 0});
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    // A cycle would end here too.
    if (tree.nodes.size() >= kMostNodes) return Broken(file, "there are more than 100,000");
    if (next.depth > kDeepest) return Broken(file, "they hang more than 1,000 deep");
    tree.nodes.push_back(MakeNode(next.node, next.parent, tree));
    if (!tree.nodes.back().world.allFinite()) {
      return Broken(
          file, std::string("the transform of ") + next.node->mName.C_Str() + " is not a number");
    }
    const int index = static_cast<int>(tree.nodes.size()) - 1;
    tree.by_name.emplace(next.node->mName.C_Str(), index);
    for (unsigned i = next.node->mNumChildren; i-- > 0;) {
      if (next.node->mChildren[i])
        waiting.push_back({next.node->mChildren[i], index, next.depth + 1});
    }
  }
  MarkMeshes(scene, &tree);
  MarkAnimated(scene, &tree);
  MarkViews(scene, &tree);
  return tree;
}

}  // namespace hazumi
