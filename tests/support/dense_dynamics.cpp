#include "tests/support/dense_dynamics.h"

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/mixed_dynamics.h"
#include "engine/matrix/cholesky.h"

namespace hazumi::test {

void InertiaMatrix(const Figure& figure, DynamicsWorkspace* ws, MatX* H) {
  H->resize(figure.num_joints(), figure.num_joints());
  for (int i = 0; i < figure.num_joints(); ++i) {
    ws->tau.setZero();
    UnitAccelerationTorques(figure, JointIndex(i), ws);
    H->col(i) = ws->tau;
  }
}

std::optional<JointIndex> ForwardDynamics(const Figure& figure, const RootMotion& root,
                                          const VecX& qd, const VecX& tau, const EndForces* ends,
                                          DynamicsWorkspace* ws, VecX* qdd) {
  const VecX zero = VecX::Zero(figure.num_joints());
  InverseDynamics(figure, root, qd, zero, ends, ws);
  *qdd = tau - ws->tau;
  MatX H;
  InertiaMatrix(figure, ws, &H);
  const int pivot = FactorCholesky(H);
  if (pivot >= 0) return JointIndex(pivot);
  SolveCholesky(H, *qdd);
  return std::nullopt;
}

}  // namespace hazumi::test
