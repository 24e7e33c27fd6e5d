// Newton-Euler recursion [Luh, Walker, Paul 1980], for every body i with parent p, world axes:
//   outwards: w, alpha, a of the joint origins (kinematics.cpp)
//   body:     F = m (a + alpha x c + w x (w x c)),  N = I alpha + w x I w
//   inwards:  f_i = F_i - Kf_i + sum f_child
//             n_i = N_i + c x F_i - Kn_i + sum (n_child + r_child x f_child)
//             tau_i = axis_i . n_i

#include "engine/dynamics/inverse_dynamics.h"

#include "engine/spatial/checks.h"

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

namespace {

// alpha = axis_i and a = axis_i x r, for a body at rest: Newton-Euler without velocity terms.
void SetUnitAccelerationForce(const RigidInertia& inertia, const Vec3& alpha, const Vec3& origin,
                              BodyScratch* body) {
  const Vec3 a_com = alpha.cross(body->p - origin + body->c);
  body->f = inertia.mass * a_com;
  body->n = body->R * (inertia.I_com * (body->R.transpose() * alpha)) + body->c.cross(body->f);
}

// The chain from joint i to the root transmits the force and moment that i's body asks for.
void TransmitToRoot(const Figure& figure, JointIndex i, DynamicsWorkspace* ws) {
  const Vec3 f = ws->body(i).f;
  Vec3 n = ws->body(i).n;
  Vec3 p = ws->body(i).p;
  for (JointIndex j = i; j.is_valid(); j = figure.joint(j).parent) {
    const BodyScratch& body = ws->body(j);
    n += (p - body.p).cross(f);
    p = body.p;
    ws->tau[j.value()] = body.axis.dot(n);
  }
  ws->bodies[0].f = f;
}

}  // namespace

void UnitAccelerationTorques(const Figure& figure, JointIndex i, DynamicsWorkspace* ws) {
  const int first = i.value(), end = figure.joint(i).subtree_end.value();
  const Vec3 alpha = ws->body(i).axis, origin = ws->body(i).p;
  for (int j = first; j < end; ++j) {
    BodyScratch& body = ws->bodies[j + 1];
    body.f.setZero();
    body.n.setZero();
    if (figure.joints()[j].massless) continue;
    SetUnitAccelerationForce(figure.body(JointIndex(j)), alpha, origin, &body);
  }
  for (int j = end - 1; j > first; --j) {
    const BodyScratch& body = ws->bodies[j + 1];
    BodyScratch& parent = ws->body(figure.joints()[j].parent);
    ws->tau[j] = body.axis.dot(body.n);
    parent.f += body.f;
    parent.n += body.n + (body.p - parent.p).cross(body.f);
  }
  TransmitToRoot(figure, i, ws);
}

}  // namespace hazumi
