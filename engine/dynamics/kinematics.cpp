#include "engine/dynamics/kinematics.h"

#include <cmath>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

void PlaceRoot(const Figure& figure, const Pose& X_WR, DynamicsWorkspace* ws) {
  ws->bodies[0].R = X_WR.R;
  ws->bodies[0].p = X_WR.p;
  ws->bodies[0].c = X_WR.R * figure.root_body().com;
}

void Place(const Figure& figure, int i, const VecX& q, DynamicsWorkspace* ws) {
  const Joint& joint = figure.joints()[i];
  const BodyScratch& parent = ws->body(joint.parent);
  BodyScratch& body = ws->bodies[i + 1];
  body.p = parent.p + parent.R * joint.X_PJ.p;
  if (joint.parallel_frame) {
    body.R = parent.R;
  } else {
    body.R.noalias() = parent.R * joint.X_PJ.R;
  }
  Turn(joint.axis, std::sin(q[i]), std::cos(q[i]), &body.R);
  body.axis = body.R * joint.axis;
  if (!joint.massless) body.c = body.R * figure.body(JointIndex(i)).com;
}

void SetVelocity(const Figure& figure, int i, const VecX& qd, DynamicsWorkspace* ws) {
  const BodyScratch& parent = ws->body(figure.joints()[i].parent);
  BodyScratch& body = ws->bodies[i + 1];
  body.w = parent.w + body.axis * qd[i];
  body.v = parent.v + parent.w.cross(body.p - parent.p);
}

void SetAcceleration(const Figure& figure, int i, const VecX& qd, const VecX& qdd,
                     DynamicsWorkspace* ws) {
  const BodyScratch& parent = ws->body(figure.joints()[i].parent);
  BodyScratch& body = ws->bodies[i + 1];
  const Vec3 r = body.p - parent.p;
  body.alpha = parent.alpha + body.axis * qdd[i] + parent.w.cross(body.axis) * qd[i];
  body.a = parent.a + parent.alpha.cross(r) + parent.w.cross(parent.w.cross(r));
}

void MoveRoot(const RootMotion& root, DynamicsWorkspace* ws) {
  ws->bodies[0].w = root.w;
  ws->bodies[0].v = root.v;
  ws->bodies[0].alpha = root.alpha;
  ws->bodies[0].a = root.a;
}

}  // namespace

void ComputePositions(const Figure& figure, const Pose& X_WR, const VecX& q,
                      DynamicsWorkspace* ws) {
  HAZUMI_ASSERT(q.size() == figure.num_joints());
  HAZUMI_ASSERT(IsRotation(X_WR.R));
  PlaceRoot(figure, X_WR, ws);
  for (int i = 0; i < figure.num_joints(); ++i) Place(figure, i, q, ws);
}

void ComputeVelocities(const Figure& figure, const Vec3& w_root, const Vec3& v_root, const VecX& qd,
                       DynamicsWorkspace* ws) {
  HAZUMI_ASSERT(qd.size() == figure.num_joints());
  ws->bodies[0].w = w_root;
  ws->bodies[0].v = v_root;
  for (int i = 0; i < figure.num_joints(); ++i) SetVelocity(figure, i, qd, ws);
}

void ComputeMotion(const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& qdd,
                   DynamicsWorkspace* ws) {
  HAZUMI_ASSERT(qd.size() == figure.num_joints() && qdd.size() == figure.num_joints());
  MoveRoot(root, ws);
  for (int i = 0; i < figure.num_joints(); ++i) {
    SetVelocity(figure, i, qd, ws);
    SetAcceleration(figure, i, qd, qdd, ws);
  }
}

void ComputeMotionTo(JointIndex tip, const Figure& figure, const Pose& X_WR, const RootMotion& root,
                     const VecX& q, const VecX& qd, const VecX& qdd, DynamicsWorkspace* ws) {
  PlaceRoot(figure, X_WR, ws);
  MoveRoot(root, ws);
  for (int i = 0; i <= tip.value(); ++i) {
    if (!figure.IsBeyond(tip, JointIndex(i))) continue;
    Place(figure, i, q, ws);
    SetVelocity(figure, i, qd, ws);
    SetAcceleration(figure, i, qd, qdd, ws);
  }
}

Vec3 CenterOfMass(const Figure& figure, const DynamicsWorkspace& ws) {
  Vec3 moment = figure.root_body().mass * (ws.bodies[0].p + ws.bodies[0].c);
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (figure.joints()[i].massless) continue;
    moment += figure.body(JointIndex(i)).mass * (ws.bodies[i + 1].p + ws.bodies[i + 1].c);
  }
  return moment / figure.total_mass();
}

Vec3 CenterOfMassVelocity(const Figure& figure, const DynamicsWorkspace& ws) {
  const BodyScratch& root = ws.bodies[0];
  Vec3 momentum = figure.root_body().mass * (root.v + root.w.cross(root.c));
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (figure.joints()[i].massless) continue;
    const BodyScratch& body = ws.bodies[i + 1];
    momentum += figure.body(JointIndex(i)).mass * (body.v + body.w.cross(body.c));
  }
  return momentum / figure.total_mass();
}

Vec3 CenterOfMassAcceleration(const Figure& figure, const DynamicsWorkspace& ws) {
  const auto of_body = [](const BodyScratch& body) -> Vec3 {
    return body.a + body.alpha.cross(body.c) + body.w.cross(body.w.cross(body.c));
  };
  Vec3 sum = figure.root_body().mass * of_body(ws.bodies[0]);
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (figure.joints()[i].massless) continue;
    sum += figure.body(JointIndex(i)).mass * of_body(ws.bodies[i + 1]);
  }
  return sum / figure.total_mass();
}

}  // namespace hazumi
