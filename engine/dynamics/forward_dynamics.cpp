#include "engine/dynamics/forward_dynamics.h"

#include "engine/dynamics/inertia_matrix.h"
#include "engine/dynamics/mixed_dynamics.h"

namespace hazumi {

std::optional<SingularInertia> ForwardDynamicsDense(const Figure& figure, const RootMotion& root,
                                                    const VecX& qd, const VecX& tau,
                                                    const EndForces* ends, DynamicsWorkspace* ws,
                                                    VecX* qdd) {
  const int n = figure.num_joints();
  ws->H.resize(n, n);
  qdd->setZero();
  InverseDynamics(figure, root, qd, *qdd, ends, ws);
  *qdd = tau - ws->tau;
  InertiaMatrixByUnitAccelerations(figure, ws, &ws->H);
  const int pivot = FactorCholesky(ws->H);
  if (pivot >= 0) return SingularInertia{JointIndex(pivot)};
  SolveCholesky(ws->H, *qdd);
  return std::nullopt;
}

}  // namespace hazumi
