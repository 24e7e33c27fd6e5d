#include "engine/region/region_system.h"

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/mixed_dynamics.h"
#include "engine/matrix/cholesky.h"

namespace hazumi {

namespace {

// A^T B, entry by entry where it is used: Eigen's ordinary product would allocate.
template <typename B>
auto TimesTransposed(const Eigen::Matrix3Xd& a, const B& b) {
  return a.transpose().lazyProduct(b);
}

}  // namespace

RegionSystem::RegionSystem(const Figure& figure, std::vector<JointIndex> free)
    : figure_(figure),
      free_(std::move(free)),
      M_(free_.size(), free_.size()),
      b_(free_.size()),
      H_root_(3, free_.size()),
      J_(3, free_.size()),
      prescribed_qdd_(figure.num_joints()) {}

void RegionSystem::Evaluate(const PassiveState& state, RootCoupling coupling, JointIndex pin,
                            double gravity, DynamicsWorkspace* ws) {
  ComputePositions(figure_, state.X_WR, state.q, ws);
  ComputeInertia(ws);
  prescribed_qdd_ = state.qdd;
  for (const JointIndex j : free_) prescribed_qdd_[j.value()] = 0.0;
  const Vec3 up(0.0, 0.0, gravity);  // minus the acceleration of gravity
  if (coupling == RootCoupling::kPrescribed) ComputeBias(state, state.root.a + up, ws);
  if (coupling == RootCoupling::kPinned) {
    RootMotion still = state.root;
    still.a.setZero();
    ComputeMotion(figure_, still, state.qd, prescribed_qdd_, ws);
    ComputeBias(state, up - ws->body(pin).a, ws);
    ProjectOnPin(pin, *ws);
  }
  if (coupling == RootCoupling::kFlight) {
    ComputeBias(state, up, ws);
    EliminateRoot();
  }
}

void RegionSystem::ComputeInertia(DynamicsWorkspace* ws) {
  for (int column = 0; column < size(); ++column) {
    ws->tau.setZero();
    UnitAccelerationTorques(figure_, free_[column], ws);
    for (int row = 0; row < size(); ++row) M_(row, column) = ws->tau[free_[row].value()];
    H_root_.col(column) = ws->bodies[0].f;
  }
}

void RegionSystem::ComputeBias(const PassiveState& state, const Vec3& root_acceleration,
                               DynamicsWorkspace* ws) {
  RootMotion root = state.root;
  root.a = root_acceleration;
  InverseDynamics(figure_, root, state.qd, prescribed_qdd_, nullptr, ws);
  for (int row = 0; row < size(); ++row) b_[row] = ws->tau[free_[row].value()];
  f_root_ = ws->bodies[0].f;
}

void RegionSystem::ProjectOnPin(JointIndex pin, const DynamicsWorkspace& ws) {
  for (int i = 0; i < size(); ++i) J_.col(i) = OriginJacobian(figure_, ws, pin, free_[i]);
  if (J_.isZero(0.0)) return;  // no free joint between root and pin: the root is prescribed
  M_ += figure_.total_mass() * TimesTransposed(J_, J_) - TimesTransposed(J_, H_root_) -
        TimesTransposed(H_root_, J_);
  b_ -= TimesTransposed(J_, f_root_);
}

void RegionSystem::EliminateRoot() {
  const double mass = figure_.total_mass();
  M_ -= TimesTransposed(H_root_, H_root_) / mass;
  b_ -= TimesTransposed(H_root_, f_root_) / mass;
}

bool RegionSystem::RatesAfterPinning(const PassiveState& state, JointIndex pin,
                                     DynamicsWorkspace* ws, VecX* rates) {
  ComputePositions(figure_, state.X_WR, state.q, ws);
  ComputeInertia(ws);
  VecX qd = state.qd, y(size());
  for (int i = 0; i < size(); ++i) {
    y[i] = qd[free_[i].value()];
    qd[free_[i].value()] = 0.0;
  }
  ComputeVelocities(figure_, state.root.w, Vec3::Zero(), qd, ws);
  const Vec3 dv = state.root.v + ws->body(pin).v;  // x' - c' of the root; of the joints it is y
  VecX momentum = M_ * y + H_root_.transpose() * dv;
  for (int i = 0; i < size(); ++i) J_.col(i) = OriginJacobian(figure_, *ws, pin, free_[i]);
  momentum -= J_.transpose() * (figure_.total_mass() * dv + H_root_ * y);
  ProjectOnPin(pin, *ws);
  if (FactorCholesky(M_) >= 0) return false;
  SolveCholesky(M_, momentum);
  *rates = momentum;
  return true;
}

}  // namespace hazumi
