#include "engine/dynamics/inverse_dynamics.h"

#include "engine/spatial/checks.h"

// Newton-Euler recursion [Luh, Walker, Paul 1980], for every body i with parent p, world axes:
//   outwards: w, alpha, a of the joint origins (kinematics.cpp)
//   body:     F = m (a + alpha x c + w x (w x c)),  N = I alpha + w x I w
//   inwards:  f_i = F_i - Kf_i + sum f_child
//             n_i = N_i + c x F_i - Kn_i + sum (n_child + r_child x f_child)
//             tau_i = axis_i . n_i

namespace hazumi {

namespace {

// Force and moment that the body's own motion asks for, about its joint origin.
void SetOwnForce(const RigidInertia& inertia, BodyScratch* body) {
  const Vec3 a_com = body->a + body->alpha.cross(body->c) + body->w.cross(body->w.cross(body->c));
  const Vec3 w_J = body->R.transpose() * body->w;
  const Vec3 alpha_J = body->R.transpose() * body->alpha;
  const Vec3 N_J = inertia.I_com * alpha_J + w_J.cross(inertia.I_com * w_J);
  body->f = inertia.mass * a_com;
  body->n = body->R * N_J + body->c.cross(body->f);
}

void SetOwnForces(const Figure& figure, DynamicsWorkspace* ws) {
  SetOwnForce(figure.root_body(), &ws->bodies[0]);
  for (int i = 0; i < figure.num_joints(); ++i) {
    BodyScratch& body = ws->bodies[i + 1];
    if (figure.joints()[i].massless) {
      body.f.setZero();
      body.n.setZero();
    } else {
      SetOwnForce(figure.body(JointIndex(i)), &body);
    }
  }
}

void SubtractEndForces(const Figure& figure, const EndForces& ends, DynamicsWorkspace* ws) {
  int end = 0;
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (!IsEndJoint(figure, JointIndex(i))) continue;
    ws->bodies[i + 1].f -= ends.Kf.col(end);
    ws->bodies[i + 1].n -= ends.Kn.col(end);
    ++end;
  }
}

}  // namespace

std::vector<JointIndex> EndJoints(const Figure& figure) {
  std::vector<JointIndex> ends;
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (IsEndJoint(figure, JointIndex(i))) ends.emplace_back(i);
  }
  return ends;
}

void InverseDynamics(const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& qdd,
                     const EndForces* ends, DynamicsWorkspace* ws) {
  HAZUMI_ASSERT(qd.size() == figure.num_joints() && qdd.size() == figure.num_joints());
  ComputeMotion(figure, root, qd, qdd, ws);
  SetOwnForces(figure, ws);
  if (ends != nullptr) SubtractEndForces(figure, *ends, ws);
  for (int i = figure.num_joints() - 1; i >= 0; --i) {
    const BodyScratch& body = ws->bodies[i + 1];
    BodyScratch& parent = ws->body(figure.joints()[i].parent);
    ws->tau[i] = body.axis.dot(body.n);
    parent.f += body.f;
    parent.n += body.n + (body.p - parent.p).cross(body.f);
  }
}

}  // namespace hazumi
