#include <Eigen/LU>
#include <algorithm>

#include "engine/base/utf8.h"
#include "engine/exchange/scene/character_parts.h"

namespace hazumi {
namespace {

constexpr float kNoticeable = 0.01f;  // of a vertex's weight

struct Influence {
  uint16_t bind;
  float weight;
};

class MeshReader {
 public:
  MeshReader(const SceneTree& tree, const SceneSkeleton& skeleton, std::vector<Warning>* warnings)
      : tree_(tree),
        skeleton_(skeleton),
        warnings_(warnings),
        is_read_(tree.scene.meshes.size(), 0) {}

  std::vector<SkinMesh> Read() {
    std::vector<SkinMesh> meshes;
    for (int node = 0; node < tree_.size(); ++node) {
      for (const int index : tree_.node(node).meshes) {
        const SceneMesh& mesh = tree_.scene.meshes[static_cast<size_t>(index)];
        // A skin lies where its bones are, not where its node is: once is enough.
        const bool is_left_out = mesh.is_skinned
                                     ? is_read_[static_cast<size_t>(index)]++ || IsOfAnother(mesh)
                                     : skeleton_.is_apart[static_cast<size_t>(node)];
        if (!is_left_out && !mesh.triangles.empty()) meshes.push_back(ReadOne(mesh, node));
      }
    }
    return meshes;
  }

 private:
  // The skin of another character: all that it follows is beside the skeleton.
  bool IsOfAnother(const SceneMesh& mesh) const {
    return !mesh.binds.empty() &&
           std::all_of(mesh.binds.begin(), mesh.binds.end(), [&](const SceneMesh::Bind& bind) {
             return skeleton_.is_apart[static_cast<size_t>(bind.node)] != 0;
           });
  }

  SkinMesh ReadOne(const SceneMesh& mesh, int node) {
    SkinMesh skin;
    skin.name = ValidUtf8(tree_.node(node).name);
    if (skin.name.empty()) skin.name = ValidUtf8(mesh.name);
    skin.material = mesh.material;
    skin.positions = mesh.positions;
    for (const Eigen::Vector3f& normal : mesh.normals) {
      const bool is_sound = normal.allFinite() && normal.norm() > 1e-6f;
      skin.normals.push_back(is_sound ? normal.normalized() : Eigen::Vector3f::UnitZ());
    }
    skin.texture_coordinates = mesh.texture_coordinates;
    skin.colors = mesh.colors;
    skin.triangles = mesh.triangles;
    BindVertices(mesh, node, &skin);
    return skin;
  }

  // A bind that keeps what hangs on a node where it is at rest.
  SkinMesh::Bind RigidBind(int node) const {
    const int bone = skeleton_.Carrier(tree_, node);
    return {bone, skeleton_.World(tree_, bone).inverse() * tree_[node].world};
  }

  void BindVertices(const SceneMesh& mesh, int node, SkinMesh* skin) {
    std::vector<std::vector<Influence>> influences(mesh.positions.size());
    for (const SceneMesh::Bind& bind : mesh.binds) AddBind(bind, skin, &influences);
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
    if (loose > 0 && mesh.is_skinned) {
      Warn(*skin, std::to_string(loose) + " vertices follow no bone; they were hung on " +
                      skeleton_.bones[static_cast<size_t>(skin->binds.back().bone)].name);
    }
  }

  void AddBind(const SceneMesh::Bind& from, SkinMesh* skin,
               std::vector<std::vector<Influence>>* influences) const {
    const int bone = skeleton_.bone_of_node[static_cast<size_t>(from.node)];
    if (bone < 0 || skin->binds.size() >= 65000) return;  // without weight
    const auto bind = static_cast<uint16_t>(skin->binds.size());
    skin->binds.push_back({bone, from.inverse_bind});
    for (const auto& [vertex, weight] : from.weights)
      (*influences)[vertex].push_back({bind, weight});
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

  const SceneTree& tree_;
  const SceneSkeleton& skeleton_;
  std::vector<Warning>* warnings_;
  std::vector<char> is_read_;
};

}  // namespace

std::vector<SkinMesh> ReadMeshes(const SceneTree& tree, const SceneSkeleton& skeleton,
                                 std::vector<Warning>* warnings) {
  return MeshReader(tree, skeleton, warnings).Read();
}

}  // namespace hazumi
