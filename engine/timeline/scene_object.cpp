#include "engine/timeline/scene_object.h"

namespace hazumi {

Vec3 BoxAround(const HeldObject& object) {
  if (const auto* sphere = std::get_if<SphereShape>(&object.shape)) {
    return Vec3::Constant(2.0 * sphere->radius);
  }
  return 2.0 * std::get<BoxShape>(object.shape).half_size;
}

Skin Stretched(const Skin& mesh, const Vec3& size) {
  constexpr double kFar = 1e30, kLeast = 1e-9;
  Vec3 low = Vec3::Constant(kFar), high = -low;
  for (const SkinMesh& part : mesh.meshes) {
    for (size_t v = 0; v < part.positions.size(); ++v) {
      const Vec3 p = PointBy(part.BindOf(v), part.positions[v]);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  Eigen::Matrix4d S = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i) {
    const double length = high[i] - low[i];
    if (length > kLeast) S(i, i) = size[i] / length;
    S(i, 3) = -S(i, i) * 0.5 * (low[i] + high[i]);
  }
  Skin stretched = mesh;
  for (SkinMesh& part : stretched.meshes) {
    for (SkinMesh::Bind& bind : part.binds) bind.inverse_bind = (S * bind.inverse_bind).eval();
  }
  return stretched;
}

}  // namespace hazumi
