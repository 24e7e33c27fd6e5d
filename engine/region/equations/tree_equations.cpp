// With x and a of the flight, X_k and A_k of a unit force along axis k on the pin,
//   a + A l = 0,   x := x + X l

#include "engine/region/equations/tree_equations.h"

#include <Eigen/Cholesky>

#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

TreeEquations::TreeEquations(const RegionModel& model)
    : bodies_(model),
      is_on_pin_(model.root_answers && model.coupling == RootCoupling::kPinned),
      pin_node_(model.pin_node),
      p_pin_(model.p_pin),
      num_free_(model.num_free) {}

void TreeEquations::Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                          double* x) {
  bodies_.Solve(layout, motion, x);
  if (!is_on_pin_) return;
  const V3 a = bodies_.AccelerationAt(pin_node_, ArmOfPin(motion));
  PushPin(layout, motion);
  KeepPin(a, layout.num_dofs(), x);
}

void TreeEquations::PushPin(const RegionLayout& layout, const std::vector<NodeMotion>& motion) {
  const V3 r = ArmOfPin(motion);
  if (pushed_.rows() != num_free_) pushed_.setZero(num_free_, 3);
  for (int axis = 0; axis < 3; ++axis) {
    bodies_.Push(layout, motion, pin_node_, r, V3(Vec3::Unit(axis)), pushed_.col(axis).data());
    pin_pushed_.col(axis) = bodies_.AccelerationAt(pin_node_, r).eigen();
  }
}

void TreeEquations::KeepPin(const V3& a, int size, double* x) const {
  const Vec3 l = pin_pushed_.ldlt().solve(-a.eigen());
  Eigen::Map<VecX>(x, size) += pushed_.topRows(size) * l;
}

// W = M^-1 S, S picking the hinges: with no torque on the others
//   S^T x = S^T x_0 + A T,   A = S^T W,   that is  A^-1 S^T x - A^-1 S^T x_0 = T
void TreeEquations::AssembleSome(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                                 const std::vector<int>& hinges) {
  HAZUMI_ASSERT(layout.num_dofs() == num_free_);
  HAZUMI_ASSERT(hinges.size() <= static_cast<size_t>(num_free_));
  const auto k = static_cast<Eigen::Index>(hinges.size());
  VecX x(num_free_), free(k);
  Solve(layout, motion, x.data());
  responses_.setZero(num_free_, k);
  MatX A(k, k);
  for (Eigen::Index c = 0; c < k; ++c) {
    const FreeHinge& hinge = layout.hinges()[hinges[c]];
    double* column = responses_.col(c).data();
    bodies_.Twist(layout, motion, hinge.node, hinge.slot, column);
    if (is_on_pin_) KeepPin(bodies_.AccelerationAt(pin_node_, ArmOfPin(motion)), num_free_, column);
    for (Eigen::Index i = 0; i < k; ++i) A(i, c) = responses_(hinges[i], c);
    free[c] = x[hinges[c]];
  }
  A = 0.5 * (A + A.transpose()).eval();
  FactorSemidefinite(A);
  some_.M.setIdentity(k, k);
  for (Eigen::Index c = 0; c < k; ++c) SolveSemidefinite(A, some_.M.col(c));
  some_.b = -some_.M * free;
}

// By an impulse on the pin that takes its velocity away; where no free joint lies between root and
// pin all that carries the island is stopped with it.
VecX TreeEquations::JumpOfPin(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              const Vec3& v_pin) {
  HAZUMI_ASSERT(IsFinite(v_pin));
  VecX jump = VecX::Zero(num_free_);
  if (is_on_pin_) {
    KeepPin(V3(v_pin), num_free_, jump.data());
  } else {
    bodies_.Shake(layout, motion, V3(Vec3(-v_pin)), jump.data());
  }
  return jump;
}

}  // namespace hazumi
