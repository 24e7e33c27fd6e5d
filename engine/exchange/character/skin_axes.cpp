// With P the matrix that takes metres and Hazumi's axes to the file's, a vertex in the world is
//   P X_WB M v = (P X_WB P^-1) (P M P^-1) (P v),
// so that bind matrices M become P M P^-1, poses likewise, and points P v.

#include "engine/exchange/character/skin_axes.h"

namespace hazumi {

namespace {

Eigen::Matrix4d Turned(const Eigen::Matrix4d& M, const FileAxes& axes) {
  Eigen::Matrix4d turned = M;
  turned.topLeftCorner<3, 3>() = axes.Turned(Mat3(M.topLeftCorner<3, 3>()));
  turned.topRightCorner<3, 1>() = axes.Point(Vec3(M.topRightCorner<3, 1>()));
  return turned;
}

}  // namespace

void PutSkinOn(const Skin& skin, const std::vector<int>& bones, const FileAxes& axes,
               Character* character) {
  character->materials = skin.materials;
  character->textures = skin.textures;
  character->meshes = skin.meshes;
  for (SkinMesh& mesh : character->meshes) {
    for (SkinMesh::Bind& bind : mesh.binds) {
      bind.bone = bones[static_cast<size_t>(bind.bone)];
      bind.inverse_bind = Turned(bind.inverse_bind, axes);
    }
    for (Eigen::Vector3f& position : mesh.positions) position = axes.Point(position);
    for (Eigen::Vector3f& normal : mesh.normals) normal = axes.Direction(normal);
  }
}

}  // namespace hazumi
