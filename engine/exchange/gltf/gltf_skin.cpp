#include "engine/exchange/gltf/gltf_mesh.h"

namespace hazumi {

namespace {

Eigen::Matrix4d LocalMatrix(const Bone& bone) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = bone.rest.R * bone.rest_scale.asDiagonal();
  M.topRightCorner<3, 1>() = bone.rest.p;
  return M;
}

// With the last row exactly 0 0 0 1.
Eigen::Matrix4d AffineInverse(const Eigen::Matrix4d& M) {
  const Mat3 inverse = Mat3(M.topLeftCorner<3, 3>()).inverse();
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = inverse;
  result.topRightCorner<3, 1>() = -(inverse * M.topRightCorner<3, 1>());
  return result;
}

void AppendColumns(const Eigen::Matrix4d& M, std::vector<float>* values) {
  const Eigen::Matrix4f rounded = M.cast<float>();
  values->insert(values->end(), rounded.data(), rounded.data() + rounded.size());
  for (size_t column = 0; column < 4; ++column) {
    (*values)[values->size() - 13 + 4 * column] = column == 3 ? 1.0f : 0.0f;
  }
}

}  // namespace

GltfSkins::GltfSkins(const std::vector<Bone>& bones) {
  std::vector<Eigen::Matrix4d> world;
  for (const Bone& bone : bones) {
    const Eigen::Matrix4d local = LocalMatrix(bone);
    world.push_back(bone.parent < 0 ? local : world[static_cast<size_t>(bone.parent)] * local);
    rest_.push_back(AffineInverse(world.back()));
  }
}

std::optional<int> GltfSkins::Bind(const SkinMesh& mesh) {
  Binding wanted(rest_.size());
  for (const SkinMesh::Bind& bind : mesh.binds) {
    auto& entry = wanted[static_cast<size_t>(bind.bone)];
    if (entry && *entry != bind.inverse_bind) return std::nullopt;
    entry = bind.inverse_bind;
  }
  for (size_t i = 0; i < skins_.size(); ++i) {
    bool fits = true;
    for (const SkinMesh::Bind& bind : mesh.binds) {
      const auto& entry = skins_[i][static_cast<size_t>(bind.bone)];
      fits = fits && (!entry || *entry == bind.inverse_bind);
    }
    if (!fits) continue;
    for (const SkinMesh::Bind& bind : mesh.binds) {
      skins_[i][static_cast<size_t>(bind.bone)] = bind.inverse_bind;
    }
    return static_cast<int>(i);
  }
  skins_.push_back(std::move(wanted));
  return static_cast<int>(skins_.size()) - 1;
}

GltfJson GltfSkins::Write(int skeleton, GltfBuffer* buffer) const {
  GltfJson skins = GltfJson::array();
  std::vector<size_t> joints;
  for (size_t i = 0; i < rest_.size(); ++i) joints.push_back(i);
  for (const Binding& binding : skins_) {
    std::vector<float> matrices;
    for (size_t i = 0; i < rest_.size(); ++i) {
      AppendColumns(binding[i].value_or(rest_[i]), &matrices);
    }
    const int accessor = buffer->AddFloats(matrices, 16, GltfUse::kPlain);
    skins.push_back(
        {{"inverseBindMatrices", accessor}, {"skeleton", skeleton}, {"joints", joints}});
  }
  return skins;
}

}  // namespace hazumi
