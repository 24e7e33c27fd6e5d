#include "engine/dynamics/inertia_column.h"

namespace hazumi {

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
