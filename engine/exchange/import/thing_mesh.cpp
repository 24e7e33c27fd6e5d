// A vertex v is at s C M v, with what takes it to the bone M, the file's axes in the world's C and
// metres per unit s; a normal is turned by the inverse transpose of C M.

#include "engine/exchange/import/thing_mesh.h"

#include <Eigen/LU>
#include <utility>

#include "engine/exchange/import/world_frame.h"

namespace hazumi {

namespace {

// As it lies in the world, in the file's unit. What was turned inside out is turned back.
void Place(const Mat3& C, SkinMesh* mesh) {
  Eigen::Matrix4d to_world = Eigen::Matrix4d::Identity();
  to_world.topLeftCorner<3, 3>() = C;
  bool is_mirrored = false;
  for (size_t v = 0; v < mesh->positions.size(); ++v) {
    const Eigen::Matrix4d M = to_world * mesh->BindOf(v);
    mesh->positions[v] = PointBy(M, mesh->positions[v]).cast<float>();
    mesh->normals[v] = NormalBy(M, mesh->normals[v]).cast<float>();
    is_mirrored = M.topLeftCorner<3, 3>().determinant() < 0.0;
  }
  for (auto& triangle : mesh->triangles) {
    if (is_mirrored) std::swap(triangle[1], triangle[2]);
  }
  mesh->binds = {{0, Eigen::Matrix4d::Identity()}};
  mesh->bind_indices.assign(mesh->positions.size(), {0, 0, 0, 0});
  mesh->weights.assign(mesh->positions.size(), {1.0f, 0.0f, 0.0f, 0.0f});
}

double MetresPerUnit(const Character& character, double longest) {
  if (character.metres_per_unit) return *character.metres_per_unit;
  for (const double unit : {1.0, 0.01}) {
    if (unit * longest <= kLongestThing) return unit;
  }
  return 0.001;
}

}  // namespace

ThingMesh MeshOfThing(const Character& character) {
  ThingMesh thing;
  thing.skin = {{"thing"}, character.meshes, character.materials, character.textures};
  const Mat3 C = AxesOf(character.up.value_or(UpAxis::kY));
  constexpr float kFar = 1e30f;
  Eigen::Vector3f low = Eigen::Vector3f::Constant(kFar), high = -low;
  for (SkinMesh& mesh : thing.skin.meshes) {
    Place(C, &mesh);
    for (const Eigen::Vector3f& p : mesh.positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  const double unit = MetresPerUnit(character, (high - low).maxCoeff());
  const Eigen::Vector3f middle = 0.5f * (low + high);
  for (SkinMesh& mesh : thing.skin.meshes) {
    for (Eigen::Vector3f& p : mesh.positions) p = static_cast<float>(unit) * (p - middle);
  }
  thing.size = unit * (high - low).cast<double>();
  return thing;
}

}  // namespace hazumi
