#include "engine/exchange/gltf/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hazumi {

namespace {

using Triangle = std::array<uint32_t, 3>;

bool IsDegenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

template <typename Vector>
std::vector<float> Flat(const std::vector<Vector>& vectors) {
  std::vector<float> values;
  values.reserve(vectors.size() * Vector::RowsAtCompileTime);
  for (const Vector& v : vectors) values.insert(values.end(), v.data(), v.data() + v.size());
  return values;
}

// Empty if any has no length.
std::vector<float> UnitNormals(const SkinMesh& mesh) {
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(mesh.normals.size());
  for (const Eigen::Vector3f& n : mesh.normals) {
    const double length = n.cast<double>().norm();
    if (!(length > 1e-12)) return {};
    normals.push_back((n.cast<double>() / length).cast<float>());
  }
  return Flat(normals);
}

// What one vertex follows: each joint once, weights that sum to 1, joint 0 where there is none.
struct Influence {
  std::array<uint16_t, 4> joints = {};
  std::array<float, 4> weights = {};
};

Influence InfluenceOf(const SkinMesh& mesh, size_t vertex) {
  Influence influence;
  size_t count = 0;
  double sum = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    const float weight = mesh.weights[vertex][i];
    if (!(weight > 0.0f)) continue;
    const int bone = mesh.binds[mesh.bind_indices[vertex][i]].bone;
    const auto end = influence.joints.begin() + static_cast<std::ptrdiff_t>(count);
    const auto same = std::find(influence.joints.begin(), end, bone);
    const auto at = static_cast<size_t>(same - influence.joints.begin());
    if (same == end) influence.joints[count++] = static_cast<uint16_t>(bone);
    influence.weights[at] += weight;
    sum += static_cast<double>(weight);
  }
  if (count == 0) {  // follows its first bone
    influence.joints[0] = static_cast<uint16_t>(mesh.binds.front().bone);
    influence.weights[0] = 1.0f;
  } else {
    for (float& weight : influence.weights) weight = static_cast<float>(weight / sum);
  }
  return influence;
}

void AddInfluences(const SkinMesh& mesh, GltfBuffer* buffer, GltfJson* attributes) {
  std::vector<uint16_t> joints;
  std::vector<float> weights;
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const Influence influence = InfluenceOf(mesh, v);
    joints.insert(joints.end(), influence.joints.begin(), influence.joints.end());
    weights.insert(weights.end(), influence.weights.begin(), influence.weights.end());
  }
  const auto most = std::max_element(joints.begin(), joints.end());
  if (most != joints.end() && *most < 256) {
    const std::vector<uint8_t> bytes(joints.begin(), joints.end());
    (*attributes)["JOINTS_0"] = buffer->AddBytes(bytes, 4, GltfUse::kVertices);
  } else {
    (*attributes)["JOINTS_0"] = buffer->AddShorts(joints, 4, GltfUse::kVertices);
  }
  (*attributes)["WEIGHTS_0"] = buffer->AddFloats(weights, 4, GltfUse::kVertices);
}

int AddTriangles(const SkinMesh& mesh, GltfBuffer* buffer) {
  std::vector<uint32_t> indices;
  for (const Triangle& t : mesh.triangles) {
    if (!IsDegenerate(t)) indices.insert(indices.end(), t.begin(), t.end());
  }
  constexpr size_t kMostShort = 0xffff;  // that number itself restarts a primitive
  if (mesh.positions.size() > kMostShort) return buffer->AddLongs(indices, 1, GltfUse::kIndices);
  const std::vector<uint16_t> shorts(indices.begin(), indices.end());
  return buffer->AddShorts(shorts, 1, GltfUse::kIndices);
}

}  // namespace

bool HasTriangles(const SkinMesh& mesh) {
  return !std::all_of(mesh.triangles.begin(), mesh.triangles.end(), IsDegenerate);
}

GltfJson GltfMesh(const SkinMesh& mesh, GltfBuffer* buffer) {
  GltfJson attributes;
  attributes["POSITION"] =
      buffer->AddFloats(Flat(mesh.positions), 3, GltfUse::kVertices, /*with_bounds=*/true);
  const std::vector<float> normals = UnitNormals(mesh);
  if (!normals.empty()) attributes["NORMAL"] = buffer->AddFloats(normals, 3, GltfUse::kVertices);
  if (!mesh.texture_coordinates.empty()) {
    attributes["TEXCOORD_0"] =
        buffer->AddFloats(Flat(mesh.texture_coordinates), 2, GltfUse::kVertices);
  }
  if (!mesh.colors.empty()) {
    attributes["COLOR_0"] = buffer->AddFloats(Flat(mesh.colors), 3, GltfUse::kVertices);
  }
  if (!mesh.binds.empty()) AddInfluences(mesh, buffer, &attributes);
  GltfJson primitive = {{"attributes", attributes}, {"indices", AddTriangles(mesh, buffer)}};
  return {{"name", mesh.name}, {"primitives", GltfJson::array({primitive})}};
}

}  // namespace hazumi
