// A pinned root that answers the free joints: its translation follows from theirs, u = -J x, so
// that the pin stays.

#include <Eigen/Cholesky>

#include "engine/passive/region_dynamics.h"
#include "engine/passive/semidefinite.h"

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

// By articulated bodies. On a pin the figure flies, pushed there as hard as keeps it in place: with
// x and a of the flight, and X_k and A_k of a unit force along axis k,
//   a + A l = 0,   x := x + X l
void RegionDynamics::SolveLarge(const RegionLayout& layout, double* x) {
  articulated_.Solve(layout, kinematics_.motion(), x);
  if (!IsOnPin()) return;
  const V3 r = kinematics_.motion()[model_.pin_node].R * V3(model_.p_pin);
  const V3 a = articulated_.AccelerationAt(model_.pin_node, r);
  PushPin(layout);
  KeepPin(a, layout.num_dofs(), x);
}

void RegionDynamics::PushPin(const RegionLayout& layout) {
  const auto& motion = kinematics_.motion();
  const int pin = model_.pin_node;
  const V3 r = motion[pin].R * V3(model_.p_pin);
  if (pushed_.rows() != num_hinges()) pushed_.setZero(num_hinges(), 3);
  for (int axis = 0; axis < 3; ++axis) {
    articulated_.Push(layout, motion, pin, r, V3(Vec3::Unit(axis)), pushed_.col(axis).data());
    pin_pushed_.col(axis) = articulated_.AccelerationAt(pin, r).eigen();
  }
}

void RegionDynamics::KeepPin(const V3& a, int size, double* x) const {
  const Vec3 l = pin_pushed_.ldlt().solve(-a.eigen());
  Eigen::Map<VecX>(x, size) += pushed_.topRows(size) * l;
}

// W = M^-1 S, S picking the hinges: with no torque on the others
//   S^T x = S^T x_0 + A T,   A = S^T W,   that is  A^-1 S^T x - A^-1 S^T x_0 = T
void RegionDynamics::AssembleSome(const std::vector<int>& hinges, double t, const VecX& q,
                                  const VecX& qd) {
  ++evaluations_;
  const auto k = static_cast<Eigen::Index>(hinges.size());
  const int n = num_hinges();
  Move(t, hinge_layout_, q.data(), qd.data());
  VecX x(n), free(k);
  SolveLarge(hinge_layout_, x.data());
  const V3 r = IsOnPin() ? kinematics_.motion()[model_.pin_node].R * V3(model_.p_pin) : V3();
  responses_.setZero(n, k);
  MatX A(k, k);
  for (Eigen::Index c = 0; c < k; ++c) {
    const FreeHinge& hinge = this->hinges()[hinges[c]];
    double* column = responses_.col(c).data();
    articulated_.Twist(hinge_layout_, kinematics_.motion(), hinge.node, hinge.slot, column);
    if (IsOnPin()) KeepPin(articulated_.AccelerationAt(model_.pin_node, r), n, column);
    for (Eigen::Index i = 0; i < k; ++i) A(i, c) = responses_(hinges[i], c);
    free[c] = x[hinges[c]];
  }
  A = 0.5 * (A + A.transpose()).eval();
  FactorSemidefinite(A);
  M_.setIdentity(k, k);
  for (Eigen::Index c = 0; c < k; ++c) SolveSemidefinite(A, M_.col(c));
  b_ = -M_ * free;
}

// By an impulse on the pin that takes its velocity away; where no free joint lies between root and
// pin all that carries the group is stopped with it.
VecX RegionDynamics::JumpOfPin(const Vec3& v_pin) {
  VecX jump = VecX::Zero(num_hinges());
  if (IsOnPin()) {
    KeepPin(V3(v_pin), num_hinges(), jump.data());
  } else {
    articulated_.Shake(hinge_layout_, kinematics_.motion(), V3(Vec3(-v_pin)), jump.data());
  }
  return jump;
}

// With Du = -v_pin - J Dy for the root:  H Dy + F^T Du = 0 along what keeps the pin still.
void RegionDynamics::PinImpulse(const Vec3& v_pin, VecX* impulse) const {
  for (int i = 0; i < num_hinges(); ++i) {
    (*impulse)[i] = (F_.col(i) - model_.mass * J_.col(i)).dot(v_pin);
  }
}

}  // namespace hazumi
