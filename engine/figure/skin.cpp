#include "engine/figure/skin.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace hazumi {

Eigen::Matrix4d SkinMesh::BindOf(size_t vertex) const {
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
  for (size_t i = 0; i < bind_indices[vertex].size(); ++i) {
    const double w = weights[vertex][i];
    if (w > 0.0) M += w * binds[bind_indices[vertex][i]].inverse_bind;
  }
  return M;
}

Eigen::Vector3d PointBy(const Eigen::Matrix4d& M, const Eigen::Vector3f& point) {
  return M.topLeftCorner<3, 3>() * point.cast<double>() + M.topRightCorner<3, 1>();
}

Eigen::Vector3d NormalBy(const Eigen::Matrix4d& M, const Eigen::Vector3f& normal) {
  const Eigen::Matrix3d A = M.topLeftCorner<3, 3>();
  Eigen::Matrix3d cofactors;  // the inverse transpose times the determinant
  for (int i = 0; i < 3; ++i) cofactors.col(i) = A.col((i + 1) % 3).cross(A.col((i + 2) % 3));
  Eigen::Vector3d turned = cofactors * normal.cast<double>();
  if (A.determinant() < 0.0) turned = -turned;
  return turned.norm() > 0.0 ? turned.normalized() : normal.cast<double>().eval();
}

}  // namespace hazumi
