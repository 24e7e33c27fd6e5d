#include "engine/exchange/assimp/assimp_scene.h"
#include "engine/exchange/scene/scene_tree.h"

namespace hazumi {
namespace {

// FBX: assimp 5.2.5 leaves lengths and axes alone and says them in the metadata.
void TakeFbx(const aiScene& from, Scene* scene) {
  int32_t up = 1, sign = 1;
  float centimetres = 1.0f;
  if (!from.mMetaData) return;
  const bool says_up = from.mMetaData->Get("UpAxis", up);
  from.mMetaData->Get("UpAxisSign", sign);
  if (says_up && sign > 0 && (up == 1 || up == 2)) {
    scene->up = up == 1 ? UpAxis::kY : UpAxis::kZ;
  } else if (says_up) {
    scene->warnings.push_back(
        {"up", "the file's up axis is neither +Y nor +Z; say which one is meant"});
  }
  if (from.mMetaData->Get("UnitScaleFactor", centimetres) && centimetres > 0.0f)
    scene->metres_per_unit = 0.01 * static_cast<double>(centimetres);
}

// Collada: assimp makes the root R s, with the unit s [m] and R from the file's axes to y up.
void TakeCollada(aiScene* from, Scene* scene) {
  const MatrixParts root = Decompose(ToMatrix(from->mRootNode->mTransformation));
  const double unit = root.scale.x();
  if (unit > 0.0) scene->metres_per_unit = unit;
  scene->up = UpAxis::kY;
  aiMatrix4x4 kept;
  const bool is_z_up = root.X.R.row(1).isApprox(Vec3::UnitZ().transpose(), 1e-5);
  if (is_z_up) {
    scene->up = UpAxis::kZ;
  } else {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        kept[static_cast<unsigned>(row)][column] = static_cast<float>(root.X.R(row, column));
    }
  }
  from->mRootNode->mTransformation = kept;
}

}  // namespace

void TakeAxesAndUnit(CharacterFormat format, aiScene* from, Scene* scene) {
  switch (format) {
    case CharacterFormat::kFbxBinary:
    case CharacterFormat::kFbxText:
      return TakeFbx(*from, scene);
    case CharacterFormat::kCollada:
      return TakeCollada(from, scene);
    case CharacterFormat::kObj:
      scene->up = UpAxis::kY;  // as most programs write it; its unit nobody knows
      return;
    default:  // glTF is what it is
      scene->up = UpAxis::kY;
      scene->metres_per_unit = 1.0;
  }
}

}  // namespace hazumi
