#include "tests/support/momentum.h"

#include "engine/dynamics/kinematics.h"

namespace hazumi::test {

namespace {

// One body's share, about the world's origin.
void Add(const RigidInertia& body, const BodyScratch& at, Momentum* sum) {
  if (body.is_massless()) return;
  const Vec3 c = at.R * body.com;
  const Vec3 v = at.v + at.w.cross(c);
  const Mat3 I = at.R * body.I_com * at.R.transpose();
  sum->mass += body.mass;
  sum->com += body.mass * (at.p + c);
  sum->com_v += body.mass * v;
  sum->L += I * at.w + body.mass * (at.p + c).cross(v);
  sum->kinetic += 0.5 * at.w.dot(I * at.w) + 0.5 * body.mass * v.squaredNorm();
}

}  // namespace

Momentum MomentumOf(const Figure& figure, const MotionLimit& motion) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, motion.X_WR, motion.q, &ws);
  ComputeVelocities(figure, motion.root_w, motion.root_v, motion.qd, &ws);
  Momentum sum{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 0.0, 0.0};
  Add(figure.root_body(), ws.bodies[0], &sum);
  for (int j = 0; j < figure.num_joints(); ++j) {
    Add(figure.body(JointIndex(j)), ws.body(JointIndex(j)), &sum);
  }
  sum.com /= sum.mass;
  sum.com_v /= sum.mass;
  sum.L -= sum.mass * sum.com.cross(sum.com_v);
  return sum;
}

}  // namespace hazumi::test
