#include "tests/support/energy.h"

#include "engine/dynamics/kinematics.h"

namespace hazumi::test {

namespace {

double KineticEnergy(const RigidInertia& body, const BodyScratch& at) {
  const Vec3 c = at.R * body.com;
  const Vec3 w_B = at.R.transpose() * at.w;
  return 0.5 * body.mass * (at.v + at.w.cross(c)).squaredNorm() + 0.5 * w_B.dot(body.I_com * w_B);
}

const RigidInertia& Body(const Figure& figure, size_t i) {
  return i == 0 ? figure.root_body() : figure.body(JointIndex(static_cast<int>(i) - 1));
}

MotionLimit AtRestRoot(const VecX& q, const VecX& qd) {
  MotionLimit state;
  state.q = q;
  state.qd = qd;
  return state;
}

DynamicsWorkspace Placed(const Figure& figure, const MotionLimit& state) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, state.X_WR, state.q, &ws);
  ComputeVelocities(figure, state.root_w, state.root_v, state.qd, &ws);
  return ws;
}

}  // namespace

double EnergyOf(const Figure& figure, const MotionLimit& state, double gravity) {
  const DynamicsWorkspace ws = Placed(figure, state);
  double sum = 0.0;
  for (size_t i = 0; i < ws.bodies.size(); ++i) {
    const RigidInertia& body = Body(figure, i);
    const Vec3 com = ws.bodies[i].p + ws.bodies[i].R * body.com;
    sum += KineticEnergy(body, ws.bodies[i]) + body.mass * gravity * com.z();
  }
  return sum;
}

double EnergyOf(const Figure& figure, const VecX& q, const VecX& qd, double gravity) {
  return EnergyOf(figure, AtRestRoot(q, qd), gravity);
}

double EnergyScale(const Figure& figure, const VecX& q, const VecX& qd, double gravity) {
  const DynamicsWorkspace ws = Placed(figure, AtRestRoot(q, qd));
  double sum = 0.0;
  for (size_t i = 0; i < ws.bodies.size(); ++i) {
    const RigidInertia& body = Body(figure, i);
    const Vec3 com = ws.bodies[i].p + ws.bodies[i].R * body.com;
    sum += KineticEnergy(body, ws.bodies[i]) + body.mass * gravity * com.norm();
  }
  return sum;
}

}  // namespace hazumi::test
