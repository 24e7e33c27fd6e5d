#include "engine/exchange/assimp/assimp_scene.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <cstring>
#include <map>
#include <unordered_map>

namespace hazumi {
namespace {

constexpr size_t kMostNodes = 100'001;  // one more than are read

Eigen::Vector3f ToVector(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Eigen::Vector4d ToKey(const aiVectorKey& key) {
  return {key.mValue.x, key.mValue.y, key.mValue.z, 0.0};
}
Eigen::Vector4d ToKey(const aiQuatKey& key) {
  return {key.mValue.x, key.mValue.y, key.mValue.z, key.mValue.w};
}

template <typename Key>
JointKeys ToKeys(const Key* keys, unsigned count, double ticks_per_second) {
  JointKeys made;
  for (unsigned i = 0; i < count; ++i) {
    made.times.push_back(keys[i].mTime / ticks_per_second);
    made.values.push_back(ToKey(keys[i]));
  }
  return made;
}

double TicksPerSecond(const aiAnimation& animation) {
  const double rate = animation.mTicksPerSecond;
  return rate > 0.0 && rate < 1e9 ? rate : 25.0;  // assimp's word for "unknown"
}

class SceneAdder {
 public:
  SceneAdder(const aiScene& from, const std::string& file, Scene* scene)
      : from_(from), file_(file), scene_(*scene) {}

  Result<Done> Add(bool ticks_are_frames) {
    AddNodes();
    MarkViews();
    AddMaterials();
    for (unsigned m = 0; m < from_.mNumMeshes; ++m) {
      if (Result<Done> added = AddMesh(*from_.mMeshes[m]); !added.ok()) return added;
    }
    for (const SceneNode& node : scene_.nodes) {
      for (const int mesh : node.meshes)
        if (mesh >= static_cast<int>(from_.mNumMeshes)) return Wrong("of a node is not there");
    }
    for (unsigned a = 0; a < from_.mNumAnimations; ++a)
      AddClip(*from_.mAnimations[a], ticks_are_frames);
    return Done{};
  }

 private:
  Error Wrong(const std::string& message) const {
    return {ErrorCode::kSemantics, file_, "meshes",
            "a mesh " + message + "; the file is broken: export it again"};
  }

  // -1: none.
  int Find(const aiString& name) const {
    const auto found = by_name_.find(name.C_Str());
    return found == by_name_.end() ? -1 : found->second;
  }

  // A cycle ends where there are too many.
  void AddNodes() {
    std::vector<std::pair<const aiNode*, int>> waiting = {{from_.mRootNode, -1}};
    while (!waiting.empty() && scene_.nodes.size() < kMostNodes) {
      const auto [node, parent] = waiting.back();
      waiting.pop_back();
      SceneNode made;
      made.name = node->mName.C_Str();
      made.parent = parent;
      made.local = ToMatrix(node->mTransformation);
      made.is_helper = std::strstr(node->mName.C_Str(), "_$AssimpFbx$_") && node->mNumChildren > 0;
      for (unsigned i = 0; i < node->mNumMeshes; ++i)
        made.meshes.push_back(static_cast<int>(node->mMeshes[i]));
      const int index = static_cast<int>(scene_.nodes.size());
      by_name_.emplace(made.name, index);
      num_children_.push_back(node->mNumChildren);
      scene_.nodes.push_back(std::move(made));
      for (unsigned i = node->mNumChildren; i-- > 0;)
        if (node->mChildren[i]) waiting.push_back({node->mChildren[i], index});
    }
  }

  void MarkViews() {
    const auto mark = [&](const aiString& name) {
      const int node = Find(name);
      if (node >= 0 && num_children_[static_cast<size_t>(node)] == 0)
        scene_.nodes[static_cast<size_t>(node)].is_view = true;
    };
    for (unsigned i = 0; i < from_.mNumCameras; ++i) mark(from_.mCameras[i]->mName);
    for (unsigned i = 0; i < from_.mNumLights; ++i) mark(from_.mLights[i]->mName);
  }

  Result<Done> AddMesh(const aiMesh& from) {
    SceneMesh mesh;
    mesh.name = from.mName.C_Str();
    mesh.is_skinned = from.HasBones();
    if (from.mMaterialIndex < from_.mNumMaterials)
      mesh.material = static_cast<int>(from.mMaterialIndex);
    if (from.HasPositions() && from.HasFaces()) {
      AddVertices(from, &mesh);
      if (!AddTriangles(from, &mesh)) return Wrong("has a triangle without a vertex");
      if (!AddBinds(from, &mesh)) return Wrong("has a weight without a vertex");
    }
    scene_.meshes.push_back(std::move(mesh));
    return Done{};
  }

  static void AddVertices(const aiMesh& from, SceneMesh* mesh) {
    for (unsigned v = 0; v < from.mNumVertices; ++v) {
      mesh->positions.push_back(ToVector(from.mVertices[v]));
      mesh->normals.push_back(from.HasNormals() ? ToVector(from.mNormals[v])
                                                : Eigen::Vector3f::UnitZ());
      if (!from.HasTextureCoords(0)) continue;
      // assimp's v points upwards.
      const aiVector3D& uv = from.mTextureCoords[0][v];
      mesh->texture_coordinates.push_back({uv.x, 1.0f - uv.y});
    }
  }

  static bool AddTriangles(const aiMesh& from, SceneMesh* mesh) {
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
      const aiFace& face = from.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      for (unsigned k = 0; k < 3; ++k)
        if (face.mIndices[k] >= from.mNumVertices) return false;
      mesh->triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    return true;
  }

  // assimp lists bones without weight with a weight of 0.
  bool AddBinds(const aiMesh& from, SceneMesh* mesh) const {
    for (unsigned b = 0; b < from.mNumBones; ++b) {
      const aiBone& bone = *from.mBones[b];
      SceneMesh::Bind bind;
      bind.node = Find(bone.mName);
      bind.inverse_bind = ToMatrix(bone.mOffsetMatrix);
      if (bind.node < 0) continue;
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        if (bone.mWeights[w].mVertexId >= from.mNumVertices) return false;
        if (bone.mWeights[w].mWeight > 0.0f)
          bind.weights.push_back({bone.mWeights[w].mVertexId, bone.mWeights[w].mWeight});
      }
      mesh->binds.push_back(std::move(bind));
    }
    return true;
  }

  void AddClip(const aiAnimation& from, bool ticks_are_frames) {
    const double per_second = TicksPerSecond(from);
    SceneClip clip;
    clip.name = from.mName.C_Str();
    clip.likely_rate = ticks_are_frames ? per_second : 0.0;
    for (unsigned c = 0; c < from.mNumChannels; ++c) {
      const aiNodeAnim& channel = *from.mChannels[c];
      const int node = Find(channel.mNodeName);
      if (node < 0) continue;
      auto motion = std::make_unique<KeyedMotion>();
      motion->translation = ToKeys(channel.mPositionKeys, channel.mNumPositionKeys, per_second);
      motion->rotation = ToKeys(channel.mRotationKeys, channel.mNumRotationKeys, per_second);
      motion->scale = ToKeys(channel.mScalingKeys, channel.mNumScalingKeys, per_second);
      clip.motions.emplace_back(node, std::move(motion));
    }
    scene_.clips.push_back(std::move(clip));
  }

  void AddMaterials() {
    for (unsigned i = 0; i < from_.mNumMaterials; ++i) {
      const aiMaterial& from = *from_.mMaterials[i];
      SceneMaterial material;
      aiString name, path;
      if (from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) material.name = name.C_Str();
      aiColor4D color;
      if (from.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
          from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
        material.base_color = {color.r, color.g, color.b, color.a};
      if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == AI_SUCCESS ||
          from.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS)
        material.picture = PictureOf(path.C_Str());
      scene_.materials.push_back(std::move(material));
    }
  }

  int PictureOf(const std::string& path) {
    const auto [known, is_new] = picture_.emplace(path, static_cast<int>(scene_.pictures.size()));
    if (!is_new) return known->second;
    ScenePicture picture{path, std::nullopt};
    if (const aiTexture* embedded = from_.GetEmbeddedTexture(path.c_str())) {
      // Height 0: as a file, of "width" bytes.
      picture.bytes.emplace();
      if (embedded->mHeight == 0)
        picture.bytes->assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
      if (embedded->mFilename.length > 0) picture.name = embedded->mFilename.C_Str();
    }
    scene_.pictures.push_back(std::move(picture));
    return known->second;
  }

  const aiScene& from_;
  const std::string& file_;
  Scene& scene_;
  std::unordered_map<std::string, int> by_name_;  // the first of a name
  std::vector<unsigned> num_children_;
  std::map<std::string, int> picture_;  // by path
};

}  // namespace

Eigen::Matrix4d ToMatrix(const aiMatrix4x4& m) {
  Eigen::Matrix4d result;
  result << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return result;
}

Result<Done> AddAssimpScene(const aiScene& from, bool ticks_are_frames, const std::string& file,
                            Scene* scene) {
  return SceneAdder(from, file, scene).Add(ticks_are_frames);
}

}  // namespace hazumi
