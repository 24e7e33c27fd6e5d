#include "engine/dynamics/inertia_matrix.h"

namespace hazumi {

namespace {

// alpha = axis_i and a = axis_i x r, for a body at rest: Newton-Euler without velocity terms.
void SetUnitAccelerationForce(const RigidInertia& inertia, const Vec3& alpha, const Vec3& origin,
                              BodyScratch* body) {
  const Vec3 a_com = alpha.cross(body->p - origin + body->c);
  body->f = inertia.mass * a_com;
  body->n = body->R * (inertia.I_com * (body->R.transpose() * alpha)) + body->c.cross(body->f);
}

// Every body's own inertia, about the root's origin, as the start of its composite.
void StartComposites(const Figure& figure, DynamicsWorkspace* ws) {
  const Vec3 o = ws->bodies[0].p;
  for (int i = 0; i < figure.num_joints(); ++i) {
    const BodyScratch& body = ws->bodies[i + 1];
    const RigidInertia& inertia = figure.body(JointIndex(i));
    DynamicsWorkspace::Composite& own = ws->composites[i];
    own = {0.0, Vec3::Zero(), Mat3::Zero(), (body.p - o).cross(body.axis)};
    if (figure.joints()[i].massless) continue;
    const Vec3 com = body.p + body.c - o;
    own.mass = inertia.mass;
    own.h = inertia.mass * com;
    own.I_o = body.R * inertia.I_com * body.R.transpose() + PointInertia(inertia.mass, com);
  }
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

void InertiaMatrixByUnitAccelerations(const Figure& figure, DynamicsWorkspace* ws, MatX* H) {
  for (int i = 0; i < figure.num_joints(); ++i) {
    ws->tau.setZero();
    UnitAccelerationTorques(figure, JointIndex(i), ws);
    H->col(i) = ws->tau;
  }
}

// With I_c the composite inertia beyond joint i, about the root's origin o: a unit rate of joint i
// about `axis` through p moves o by v = (p - o) x axis, and needs the momentum
//   f = m v + axis x h,   n = I_o axis + h x v;   H_ij = axis_j . n + v_j . f
// for every j between the root and i.
void InertiaMatrixByCompositeBodies(const Figure& figure, DynamicsWorkspace* ws, MatX* H) {
  StartComposites(figure, ws);
  H->setZero();
  for (int i = figure.num_joints() - 1; i >= 0; --i) {
    const DynamicsWorkspace::Composite& own = ws->composites[i];
    const Vec3& axis = ws->bodies[i + 1].axis;
    const Vec3 f = own.mass * own.v + axis.cross(own.h);
    const Vec3 n = own.I_o * axis + own.h.cross(own.v);
    for (JointIndex j(i); j.is_valid(); j = figure.joint(j).parent) {
      const double entry = ws->body(j).axis.dot(n) + ws->composites[j.value()].v.dot(f);
      (*H)(i, j.value()) = (*H)(j.value(), i) = entry;
    }
    const JointIndex parent = figure.joints()[i].parent;
    if (!parent.is_valid()) continue;
    DynamicsWorkspace::Composite& whole = ws->composites[parent.value()];
    whole.mass += own.mass;
    whole.h += own.h;
    whole.I_o += own.I_o;
  }
}

}  // namespace hazumi
