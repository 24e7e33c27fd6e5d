#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

Eigen::Matrix4d MatrixOf(const BonePose& pose) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = pose.R * pose.stretch;
  M.topRightCorner<3, 1>() = pose.p;
  return M;
}

// The kept bone that a bone follows: itself, or the nearest one above it; else the root.
int KeptFor(int bone, const Character& character, const Skeleton& skeleton) {
  while (bone >= 0 && skeleton.kept[bone] < 0) bone = character.bones[bone].parent;
  return bone < 0 ? 0 : skeleton.kept[bone];
}

}  // namespace

Skin SkinFor(const Character& character, const Skeleton& skeleton, const FigurePlan& plan,
             const WorldFrame& world) {
  Skin skin;
  skin.meshes = character.meshes;
  skin.materials = character.materials;
  skin.textures = character.textures;
  for (const PlannedJoint& joint : plan.joints) skin.bones.push_back(joint.name);
  Eigen::Matrix4d to_world = Eigen::Matrix4d::Identity();
  to_world.topLeftCorner<3, 3>() = world.metres * world.F * world.C;
  for (SkinMesh& mesh : skin.meshes) {
    for (SkinMesh::Bind& bind : mesh.binds) {
      const int kept = KeptFor(bind.bone, character, skeleton);
      const BonePose& rest = skeleton.rest[skeleton.bones[kept].bone];
      // At rest the body's axes are the bone's, turned into the world's; the root's are the
      // world's.
      Pose X_WB{world.AxesInWorld(rest.R), world.Placed(rest.p)};
      if (kept == 0) X_WB.R = Mat3::Identity();
      Eigen::Matrix4d X_BW = Eigen::Matrix4d::Identity();
      X_BW.topLeftCorner<3, 3>() = X_WB.Inverse().R;
      X_BW.topRightCorner<3, 1>() = X_WB.Inverse().p;
      bind.inverse_bind =
          (X_BW * to_world * MatrixOf(skeleton.rest[bind.bone]) * bind.inverse_bind).eval();
      bind.inverse_bind.row(3) << 0, 0, 0, 1;  // not nearly
      bind.bone = kept;
    }
  }
  return skin;
}

}  // namespace hazumi
