#pragma once

// Objects of an FBX file that say how nodes move, each made from its record.

#include <string>
#include <string_view>

#include "engine/exchange/fbx/fbx_records.h"
#include "engine/exchange/scene/scalar_curve.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Properties of a node as the file has them.
struct FbxModel {
  std::string name;
  Vec3 T = Vec3::Zero(), R = Vec3::Zero(), S = Vec3::Ones();
  Vec3 rotation_offset = Vec3::Zero(), rotation_pivot = Vec3::Zero();
  Vec3 scaling_offset = Vec3::Zero(), scaling_pivot = Vec3::Zero();
  Vec3 pre = Vec3::Zero(), post = Vec3::Zero();  // angles [deg]
  Vec3 geometric_T = Vec3::Zero(), geometric_R = Vec3::Zero(), geometric_S = Vec3::Ones();
  int order = 0;

  // X of fbx_motions.h, of a translation, angles [deg] and a scale.
  Eigen::Matrix4d Transform(const Vec3& t, const Vec3& angles, const Vec3& scale) const;
  Eigen::Matrix4d Geometry() const;  // G
};

// An animation: times count from its start.
struct FbxStack {
  std::string name;
  double start = 0.0, stop = 0.0;  // [s]

  // A stack that states no times begins with its first key, as assimp takes it.
  bool has_times() const { return start != 0.0 || stop != 0.0; }
};

// Name of an object, without its class.
std::string FbxNameOf(const FbxRecord& record);
// First number of a property; `otherwise` if there is none.
double FbxNumberOf(const FbxRecord& record, std::string_view name, double otherwise);
FbxModel FbxModelOf(const FbxRecord& record);
FbxStack FbxStackOf(const FbxRecord& record);
// [FBX: KeyAttrFlags and four KeyAttrDataFloat for as many keys as KeyAttrRefCount says: the slope
// behind the key, that before the next one, both weights, velocities].
ScalarCurve FbxCurveOf(const FbxRecord& record);

}  // namespace hazumi
