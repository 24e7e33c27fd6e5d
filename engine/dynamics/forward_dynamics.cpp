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

namespace {

Mat3 Skew(const Vec3& x) {
  Mat3 S;
  S << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return S;
}

// Spatial inertia about the root's origin o, angular part first.
Mat6 SpatialInertiaOf(const RigidInertia& inertia, const BodyScratch& body, const Vec3& o) {
  const Vec3 com = body.p + body.c - o;
  const Mat3 h = inertia.mass * Skew(com);
  Mat6 I;
  I.topLeftCorner<3, 3>() =
      body.R * inertia.I_com * body.R.transpose() + PointInertia(inertia.mass, com);
  I.topRightCorner<3, 3>() = h;
  I.bottomLeftCorner<3, 3>() = h.transpose();
  I.bottomRightCorner<3, 3>() = inertia.mass * Mat3::Identity();
  return I;
}

Vec6 CrossMotion(const Vec6& v, const Vec6& m) {
  Vec6 x;
  x << v.head<3>().cross(m.head<3>()),
      v.head<3>().cross(m.tail<3>()) + v.tail<3>().cross(m.head<3>());
  return x;
}

Vec6 CrossForce(const Vec6& v, const Vec6& f) {
  Vec6 x;
  x << v.head<3>().cross(f.head<3>()) + v.tail<3>().cross(f.tail<3>()),
      v.head<3>().cross(f.tail<3>());
  return x;
}

using Articulated = DynamicsWorkspace::Articulated;

// Outwards: velocities, velocity-product accelerations c and bias forces pA.
void StartArticulated(const Figure& figure, const Vec6& v_root, const VecX& qd,
                      DynamicsWorkspace* ws) {
  const Vec3 o = ws->bodies[0].p;
  for (int i = 0; i < figure.num_joints(); ++i) {
    const BodyScratch& body = ws->bodies[i + 1];
    const JointIndex parent = figure.joints()[i].parent;
    Articulated& own = ws->articulated[i];
    own.S << body.axis, (body.p - o).cross(body.axis);
    const Vec6& v_parent = parent.is_valid() ? ws->articulated[parent.value()].v : v_root;
    own.v = v_parent + own.S * qd[i];
    own.c = CrossMotion(own.v, own.S * qd[i]);
    own.IA.setZero();
    own.pA.setZero();
    if (figure.joints()[i].massless) continue;
    own.IA = SpatialInertiaOf(figure.body(JointIndex(i)), body, o);
    own.pA = CrossForce(own.v, own.IA * own.v);
  }
}

void SubtractEndForces(const Figure& figure, const EndForces& ends, DynamicsWorkspace* ws) {
  const Vec3 o = ws->bodies[0].p;
  int end = 0;
  for (int i = 0; i < figure.num_joints(); ++i) {
    if (!IsEndJoint(figure, JointIndex(i))) continue;
    const Vec3 force = ends.Kf.col(end);
    Vec6 wrench;
    wrench << ends.Kn.col(end) + (ws->bodies[i + 1].p - o).cross(force), force;
    ws->articulated[i].pA -= wrench;
    ++end;
  }
}

// Hinges that line up leave nothing but rounding of D = S^T IA S, which is at most about this.
double SizeOfD(const Articulated& own) {
  return own.IA.topLeftCorner<3, 3>().trace() +
         own.S.tail<3>().squaredNorm() * own.IA.bottomRightCorner<3, 3>().trace();
}

// Inwards: articulated inertias and bias forces.
std::optional<SingularInertia> GatherArticulated(const Figure& figure, const VecX& tau,
                                                 DynamicsWorkspace* ws) {
  for (int i = figure.num_joints() - 1; i >= 0; --i) {
    Articulated& own = ws->articulated[i];
    own.U = own.IA * own.S;
    own.D = own.S.dot(own.U);
    if (!(own.D > 1e-14 * SizeOfD(own))) return SingularInertia{JointIndex(i)};
    own.u = tau[i] - own.S.dot(own.pA);
    const JointIndex parent = figure.joints()[i].parent;
    if (!parent.is_valid()) continue;
    Articulated& whole = ws->articulated[parent.value()];
    const Mat6 Ia = own.IA - own.U * (own.U / own.D).transpose();
    whole.IA += Ia;
    whole.pA += own.pA + Ia * own.c + own.U * (own.u / own.D);
  }
  return std::nullopt;
}

}  // namespace

std::optional<SingularInertia> ForwardDynamicsByArticulatedBodies(
    const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& tau,
    const EndForces* ends, DynamicsWorkspace* ws, VecX* qdd) {
  // Seen from a frame that moves along with the root at this instant, the root's velocity is zero.
  Vec6 v_root, a_root;
  v_root << root.w, Vec3::Zero();
  a_root << root.alpha, root.a;
  StartArticulated(figure, v_root, qd, ws);
  if (ends != nullptr) SubtractEndForces(figure, *ends, ws);
  if (auto singular = GatherArticulated(figure, tau, ws)) return singular;
  for (int i = 0; i < figure.num_joints(); ++i) {
    Articulated& own = ws->articulated[i];
    const JointIndex parent = figure.joints()[i].parent;
    own.a = (parent.is_valid() ? ws->articulated[parent.value()].a : a_root) + own.c;
    (*qdd)[i] = (own.u - own.U.dot(own.a)) / own.D;
    own.a += own.S * (*qdd)[i];
  }
  return std::nullopt;
}

}  // namespace hazumi
