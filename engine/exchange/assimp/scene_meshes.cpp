#include "engine/exchange/assimp/scene_meshes.h"

#include <Eigen/LU>
#include <algorithm>

#include "engine/base/utf8.h"

namespace hazumi {
namespace {

constexpr float kNoticeable = 0.01f;  // of a vertex's weight

struct Influence {
  uint16_t bind;
  float weight;
};

class MeshReader {
 public:
  MeshReader(const aiScene& scene, const SceneTree& tree, const SceneSkeleton& skeleton,
             const std::string& file, std::vector<Warning>* warnings)
      : scene_(scene),
        tree_(tree),
        skeleton_(skeleton),
        file_(file),
        warnings_(warnings),
        is_read_(scene.mNumMeshes, 0) {}

  Result<std::vector<SkinMesh>> Read() {
    std::vector<SkinMesh> meshes;
    for (size_t node = 0; node < tree_.nodes.size(); ++node) {
      for (unsigned i = 0; i < tree_.nodes[node].node->mNumMeshes; ++i) {
        const unsigned index = tree_.nodes[node].node->mMeshes[i];
        if (index >= scene_.mNumMeshes) return Wrong("of a node is not there");
        const aiMesh& mesh = *scene_.mMeshes[index];
        // A skin lies where its bones are, not where its node is: once is enough.
        if (mesh.HasBones() ? is_read_[index]++ : skeleton_.is_apart[node]) continue;
        if (!mesh.HasPositions() || !mesh.HasFaces()) continue;
        Result<SkinMesh> read = ReadOne(mesh, static_cast<int>(node));
        if (!read.ok()) return read.error();
        if (!read.value().triangles.empty()) meshes.push_back(std::move(read).value());
      }
    }
    return meshes;
  }

 private:
  Error Wrong(const std::string& message) const {
    return {ErrorCode::kSemantics, file_, "meshes",
            "a mesh " + message + "; the file is broken: export it again"};
  }

  Result<SkinMesh> ReadOne(const aiMesh& mesh, int node) {
    SkinMesh skin;
    skin.name = ValidUtf8(tree_.nodes[static_cast<size_t>(node)].node->mName.C_Str());
    if (skin.name.empty()) skin.name = ValidUtf8(mesh.mName.C_Str());
    if (mesh.mMaterialIndex < scene_.mNumMaterials)
      skin.material = static_cast<int>(mesh.mMaterialIndex);
    CopyVertices(mesh, &skin);
    if (!CopyTriangles(mesh, &skin)) return Wrong("has a triangle without a vertex");
    if (!BindVertices(mesh, node, &skin)) return Wrong("has a weight without a vertex");
    return skin;
  }

  static void CopyVertices(const aiMesh& mesh, SkinMesh* skin) {
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& p = mesh.mVertices[v];
      const aiVector3D n = mesh.HasNormals() ? mesh.mNormals[v] : aiVector3D(0, 0, 1);
      const Eigen::Vector3f normal(n.x, n.y, n.z);
      const bool is_sound = normal.allFinite() && normal.norm() > 1e-6f;
      skin->positions.push_back({p.x, p.y, p.z});
      skin->normals.push_back(is_sound ? normal.normalized() : Eigen::Vector3f::UnitZ());
      if (!mesh.HasTextureCoords(0)) continue;
      // assimp's v points upwards.
      const aiVector3D& uv = mesh.mTextureCoords[0][v];
      skin->texture_coordinates.push_back({uv.x, 1.0f - uv.y});
    }
  }

  static bool CopyTriangles(const aiMesh& mesh, SkinMesh* skin) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      for (unsigned k = 0; k < 3; ++k)
        if (face.mIndices[k] >= mesh.mNumVertices) return false;
      skin->triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    return true;
  }

  // A bind that keeps what hangs on a node where it is at rest.
  SkinMesh::Bind RigidBind(int node) const {
    const int bone = skeleton_.Carrier(tree_, node);
    return {bone,
            skeleton_.World(tree_, bone).inverse() * tree_.nodes[static_cast<size_t>(node)].world};
  }

  bool BindVertices(const aiMesh& mesh, int node, SkinMesh* skin) {
    std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b)
      if (!AddBind(*mesh.mBones[b], skin, &influences)) return false;
    int cut = 0, loose = 0;
    int rigid_bind = -1;
    for (std::vector<Influence>& of_vertex : influences) {
      if (of_vertex.empty()) {
        if (rigid_bind < 0) {
          rigid_bind = static_cast<int>(skin->binds.size());
          skin->binds.push_back(RigidBind(node));
        }
        of_vertex.push_back({static_cast<uint16_t>(rigid_bind), 1.0f});
        ++loose;
      }
      cut += AddWeights(&of_vertex, skin);
    }
    if (cut > 0) {
      Warn(*skin, std::to_string(cut) +
                      " vertices follow more than four bones; the strongest four were kept");
    }
    if (loose > 0 && mesh.HasBones()) {
      Warn(*skin, std::to_string(loose) + " vertices follow no bone; they were hung on " +
                      skeleton_.bones[static_cast<size_t>(skin->binds.back().bone)].name);
    }
    return true;
  }

  bool AddBind(const aiBone& bone, SkinMesh* skin,
               std::vector<std::vector<Influence>>* influences) const {
    const int node = tree_.Find(bone.mName);
    const int index = node < 0 ? -1 : skeleton_.bone_of_node[static_cast<size_t>(node)];
    if (index < 0 || skin->binds.size() >= 65000) return true;  // without weight, or not a node
    const auto bind = static_cast<uint16_t>(skin->binds.size());
    skin->binds.push_back({index, ToMatrix(bone.mOffsetMatrix)});
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      if (bone.mWeights[w].mVertexId >= influences->size()) return false;
      if (bone.mWeights[w].mWeight > 0.0f)
        (*influences)[bone.mWeights[w].mVertexId].push_back({bind, bone.mWeights[w].mWeight});
    }
    return true;
  }

  // 1 if something noticeable was cut off.
  static int AddWeights(std::vector<Influence>* influences, SkinMesh* skin) {
    std::sort(influences->begin(), influences->end(), [](const Influence& a, const Influence& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.bind < b.bind;
    });
    float all = 0.0f, kept = 0.0f;
    for (size_t k = 0; k < influences->size(); ++k) {
      all += (*influences)[k].weight;
      if (k < 4) kept += (*influences)[k].weight;
    }
    std::array<uint16_t, 4> indices = {};
    std::array<float, 4> weights = {};
    for (size_t k = 0; k < std::min<size_t>(4, influences->size()); ++k) {
      indices[k] = (*influences)[k].bind;
      weights[k] = (*influences)[k].weight / kept;
    }
    skin->bind_indices.push_back(indices);
    skin->weights.push_back(weights);
    return all - kept > kNoticeable * all ? 1 : 0;
  }

  void Warn(const SkinMesh& skin, const std::string& message) {
    warnings_->push_back({"mesh " + skin.name, message});
  }

  const aiScene& scene_;
  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  const std::string& file_;
  std::vector<Warning>* warnings_;
  std::vector<char> is_read_;
};

}  // namespace

Result<std::vector<SkinMesh>> ReadMeshes(const aiScene& scene, const SceneTree& tree,
                                         const SceneSkeleton& skeleton, const std::string& file,
                                         std::vector<Warning>* warnings) {
  return MeshReader(scene, tree, skeleton, file, warnings).Read();
}

}  // namespace hazumi
