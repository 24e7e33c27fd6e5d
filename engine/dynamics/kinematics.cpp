#include "engine/dynamics/kinematics.h"

#include <cmath>

namespace hazumi {

void ComputePositions(const Figure& figure, const Pose& X_WR, const VecX& q,
                      DynamicsWorkspace* ws) {
  ws->bodies[0].R = X_WR.R;
  ws->bodies[0].p = X_WR.p;
  ws->bodies[0].c = X_WR.R * figure.root_body().com;
  for (int i = 0; i < figure.num_joints(); ++i) {
    const Joint& joint = figure.joints()[i];
    const BodyScratch& parent = ws->body(joint.parent);
    BodyScratch& body = ws->bodies[i + 1];
    const Mat3 turn = AxisRotation<double>(joint.axis, std::sin(q[i]), std::cos(q[i]));
    body.p = parent.p + parent.R * joint.X_PJ.p;
    if (joint.parallel_frame) {
      body.R.noalias() = parent.R * turn;
    } else {
      body.R.noalias() = parent.R * (joint.X_PJ.R * turn).eval();
    }
    body.axis = body.R * joint.axis;
    if (!joint.massless) body.c = body.R * figure.body(JointIndex(i)).com;
  }
}

void ComputeVelocities(const Figure& figure, const Vec3& w_root, const Vec3& v_root, const VecX& qd,
                       DynamicsWorkspace* ws) {
  ws->bodies[0].w = w_root;
  ws->bodies[0].v = v_root;
  for (int i = 0; i < figure.num_joints(); ++i) {
    const BodyScratch& parent = ws->body(figure.joints()[i].parent);
    BodyScratch& body = ws->bodies[i + 1];
    body.w = parent.w + body.axis * qd[i];
    body.v = parent.v + parent.w.cross(body.p - parent.p);
  }
}

void ComputeMotion(const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& qdd,
                   DynamicsWorkspace* ws) {
  ComputeVelocities(figure, root.w, root.v, qd, ws);
  ws->bodies[0].alpha = root.alpha;
  ws->bodies[0].a = root.a;
  for (int i = 0; i < figure.num_joints(); ++i) {
    const BodyScratch& parent = ws->body(figure.joints()[i].parent);
    BodyScratch& body = ws->bodies[i + 1];
    const Vec3 r = body.p - parent.p;
    body.alpha = parent.alpha + body.axis * qdd[i] + parent.w.cross(body.axis) * qd[i];
    body.a = parent.a + parent.alpha.cross(r) + parent.w.cross(parent.w.cross(r));
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

}  // namespace hazumi
