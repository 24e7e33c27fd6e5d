// A pinned root that answers the free joints: its translation follows from theirs, u = -J x, so
// that the pin stays.

#include <Eigen/Cholesky>

#include "engine/passive/region_dynamics.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

void RegionDynamics::ProjectOnPin(const RegionLayout& layout) {
  const auto& motion = kinematics_.motion();
  const Vec3 f_root = motion[0].f.eigen();
  const NodeMotion& pin = motion[model_.pin_node];
  const V3 p_pin = pin.p + pin.R * V3(model_.p_pin);
  J_.leftCols(layout.num_dofs()).setZero();
  for (int i = model_.pin_node; i >= 0; i = model_.nodes[i].parent) {
    const RegionLayout::Node& where = layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) {
      J_.col(where.dof + k) = Cross(motion[i].axis[k], p_pin - motion[i].p).eigen();
    }
  }
  for (int j = 0; j < layout.num_dofs(); ++j) {
    const Vec3 push = model_.mass * J_.col(j) - F_.col(j);
    for (int i = 0; i < layout.num_dofs(); ++i) {
      M_(i, j) += J_.col(i).dot(push) - F_.col(i).dot(J_.col(j));
    }
    b_[j] -= J_.col(j).dot(f_root);
  }
}

// The figure flies, pushed on its pin as hard as keeps that in place: with x and a of the flight,
// and X_k and A_k of a unit force along axis k,
//   a + A l = 0,   x := x + X l
void RegionDynamics::SolveOnPin(double* x) {
  const auto& motion = kinematics_.motion();
  const int pin = model_.pin_node, k = layout_.num_dofs();
  const V3 r = motion[pin].R * V3(model_.p_pin);
  const Vec3 a = articulated_.AccelerationAt(pin, r).eigen();
  if (pushed_.rows() != num_hinges()) pushed_.setZero(num_hinges(), 3);
  Mat3 A;
  for (int axis = 0; axis < 3; ++axis) {
    articulated_.Push(layout_, motion, pin, r, V3(Vec3::Unit(axis)), pushed_.col(axis).data());
    A.col(axis) = articulated_.AccelerationAt(pin, r).eigen();
  }
  const Vec3 l = A.ldlt().solve(-a);
  Eigen::Map<VecX>(x, k) += pushed_.topRows(k) * l;
}

// With Du = -v_pin - J Dy for the root:  H Dy + F^T Du = 0 along what keeps the pin still.
void RegionDynamics::PinBlow(const Vec3& v_pin, VecX* blow) const {
  for (int i = 0; i < num_hinges(); ++i) {
    (*blow)[i] = (F_.col(i) - model_.mass * J_.col(i)).dot(v_pin);
  }
}

}  // namespace hazumi
