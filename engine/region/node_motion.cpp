#include "engine/region/node_motion.h"

#include <cmath>

#include "engine/spatial/checks.h"

// For every node i with parent p, with the accelerations of free hinges zero:
//   outwards  R, p, w, alpha, a of the node (as kinematics.h)
//   its body  f = m a + alpha x h + w x (w x h),  n = I alpha + w x I w + h x a
// with h = m c and I about the node's origin

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// R := R Rot(axis, angle), by its sine and cosine. About a coordinate axis only two columns change.
HAZUMI_INLINE void Turn(const NodeHinge& hinge, double sine, double c, M3* R) {
  const M3 was = *R;
  const double s = hinge.sign * sine;
  switch (hinge.cardinal) {
    case 0:
      R->b = c * was.b + s * was.c;
      R->c = c * was.c - s * was.b;
      return;
    case 1:
      R->c = c * was.c + s * was.a;
      R->a = c * was.a - s * was.c;
      return;
    case 2:
      R->a = c * was.a + s * was.b;
      R->b = c * was.b - s * was.a;
      return;
    default:
      *R = was * ToSmall(AxisRotation<double>(hinge.axis, s, c));
  }
}

HAZUMI_INLINE V3 AxisOf(const NodeHinge& hinge, const V3& axis, const M3& R) {
  switch (hinge.cardinal) {
    case 0:
      return hinge.sign * R.a;
    case 1:
      return hinge.sign * R.b;
    case 2:
      return hinge.sign * R.c;
    default:
      return R * axis;
  }
}

HAZUMI_INLINE M3 FromQuaternion(const double* q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double s = 2.0 / (w * w + x * x + y * y + z * z);
  const double sx = s * x, sy = s * y, sz = s * z;
  const double xx = sx * x, xy = sx * y, xz = sx * z, yy = sy * y, yz = sy * z, zz = sz * z;
  const double wx = sx * w, wy = sy * w, wz = sz * w;
  return {{1.0 - yy - zz, xy + wz, xz - wy},
          {xy - wz, 1.0 - xx - zz, yz + wx},
          {xz + wy, yz - wx, 1.0 - xx - yy}};
}

// R I R^T of a diagonal I, with R R^T = 1 taken out.
HAZUMI_INLINE S3 RotatedDiagonal(const M3& R, const S3& I) {
  const V3 a = (I.xx - I.zz) * R.a, b = (I.yy - I.zz) * R.b;
  return {a.x * R.a.x + b.x * R.b.x + I.zz, a.x * R.a.y + b.x * R.b.y,
          a.x * R.a.z + b.x * R.b.z,        a.y * R.a.y + b.y * R.b.y + I.zz,
          a.y * R.a.z + b.y * R.b.z,        a.z * R.a.z + b.z * R.b.z + I.zz};
}

}  // namespace

NodeKinematics::NodeKinematics(const RegionModel& model)
    : R_root_(ToSmall(model.R_root)), motion_(model.num_nodes()), turns_(model.num_free) {
  for (const ModelNode& from : model.nodes) {
    const S3 I = ToSymmetric(from.body.I_com + PointInertia(from.body.mass, from.body.com));
    Node node{from.parent,
              from.p_P,
              from.num_hinges,
              from.hinges,
              {},
              from.is_dynamic,
              from.body.is_massless(),
              from.body.mass,
              V3(from.body.mass * from.body.com),
              I,
              I.xy == 0.0 && I.xz == 0.0 && I.yz == 0.0};
    for (int h = 0; h < from.num_hinges; ++h) node.axis[h] = from.hinges[h].axis;
    nodes_.push_back(node);
  }
}

void NodeKinematics::Move(const RegionLayout& layout, const DrivenMotion& driven, double t,
                          const double* positions, const double* velocities, int first, int last) {
  HAZUMI_ASSERT(0 <= first && first <= last && last <= size());
  HAZUMI_ASSERT((positions == nullptr) == (velocities == nullptr));
  if (positions != nullptr) turns_.Set(positions, layout.angles());
  for (int i = first; i < last; ++i) {
    const Node& node = nodes_[i];
    NodeMotion& own = motion_[i];
    Frame frame{R_root_, {}, {}};
    if (node.parent < 0) {
      own.p = own.r = own.a = V3();
    } else {
      const NodeMotion& parent = motion_[node.parent];
      frame = {parent.R, parent.w, parent.alpha};
      const V3 r = frame.R * node.p_P;
      own.r = r;
      own.p = parent.p + r;
      own.a = parent.a + Cross(frame.alpha, r) + Cross(frame.w, Cross(frame.w, r));
    }
    using Kind = RegionLayout::NodeKind;
    const RegionLayout::Node& where = layout.node(i);
    if (where.kind == Kind::kBall) TurnBall(where, positions, velocities, &frame, &own);
    if (where.kind == Kind::kHinges) TurnHinges(node, where, velocities, &frame, &own);
    if (where.kind == Kind::kDriven) TurnDriven(node, driven, t, &frame);
    own.R = frame.R;
    own.w = frame.w;
    own.alpha = frame.alpha;
  }
}

HAZUMI_INLINE void NodeKinematics::TurnDriven(const Node& node, const DrivenMotion& driven,
                                              double t, Frame* frame) const {
  for (int h = 0; h < node.num_hinges; ++h) {
    const Jet q = driven.angles[node.hinges[h].coordinate].At(t);
    const V3 axis = AxisOf(node.hinges[h], node.axis[h], frame->R);
    frame->alpha += q.dd * axis + q.d * Cross(frame->w, axis);
    frame->w += q.d * axis;
    Turn(node.hinges[h], std::sin(q.v), std::cos(q.v), &frame->R);
  }
}

HAZUMI_INLINE void NodeKinematics::TurnHinges(const Node& node, const RegionLayout::Node& layout,
                                              const double* velocities, Frame* frame,
                                              NodeMotion* own) const {
  int free = 0;
  for (int h = 0; h < node.num_hinges; ++h) {
    if (layout.locked[h]) {
      Turn(node.hinges[h], layout.sine[h], layout.cosine[h], &frame->R);
      continue;
    }
    const double rate = velocities[layout.dof + free];
    const V3 axis = AxisOf(node.hinges[h], node.axis[h], frame->R);
    own->axis[free] = axis;
    frame->alpha += rate * Cross(frame->w, axis);
    frame->w += rate * axis;
    const int turn = layout.first_angle + free;
    Turn(node.hinges[h], turns_.sine(turn), turns_.cosine(turn), &frame->R);
    ++free;
  }
}

HAZUMI_INLINE void NodeKinematics::TurnBall(const RegionLayout::Node& layout,
                                            const double* positions, const double* velocities,
                                            Frame* frame, NodeMotion* own) {
  const M3 R = frame->R * FromQuaternion(positions + layout.position);
  frame->R = R;
  own->axis = {R.a, R.b, R.c};
  const double* v = velocities + layout.dof;
  const V3 w = v[0] * R.a + v[1] * R.b + v[2] * R.c;
  frame->alpha += Cross(frame->w, w);
  frame->w += w;
}

void NodeKinematics::Accelerate(const RegionLayout& layout, const double* x, int first) {
  HAZUMI_ASSERT(0 <= first && first <= size());
  dalpha_.assign(size(), V3());
  da_.assign(size(), V3());
  for (int i = first; i < size(); ++i) {
    NodeMotion& own = motion_[i];
    const int parent = nodes_[i].parent;
    if (parent >= 0) {
      dalpha_[i] = dalpha_[parent];
      da_[i] = da_[parent] + Cross(dalpha_[parent], own.r);
    }
    const RegionLayout::Node& where = layout.node(i);
    for (int k = 0; k < where.num_dofs; ++k) dalpha_[i] += x[where.dof + k] * own.axis[k];
    own.alpha += dalpha_[i];
    own.a += da_[i];
  }
}

V3 NodeKinematics::AskedForce() const {
  V3 force;
  for (int i = 0; i < size(); ++i) {
    const NodeMotion& own = motion_[i];
    if (nodes_[i].is_dynamic) force += own.f + own.m * da_[i] + Cross(dalpha_[i], own.h);
  }
  return force;
}

void NodeKinematics::SetOwnForces(const V3& base) {
  added_force_ = V3();
  for (int i = 0; i < size(); ++i) {
    const Node& node = nodes_[i];
    if (!node.is_dynamic) continue;
    NodeMotion& own = motion_[i];
    own.m = node.mass;
    if (node.is_massless) {
      own.f = own.n = own.h = V3();
      own.I = S3();
      continue;
    }
    const M3 R = own.R;
    const V3 w = own.w, alpha = own.alpha, a = own.a + base;
    const V3 h = R * node.h;
    const S3 I = node.is_diagonal ? RotatedDiagonal(R, node.I) : Rotated(R, node.I);
    own.f = node.mass * a + Cross(alpha, h) + Cross(w, Cross(w, h));
    own.n = I * alpha + Cross(w, I * w) + Cross(h, a);
    own.h = h;
    own.I = I;
  }
}

// What a node is given it does not ask for.
void NodeKinematics::AddForce(int node, const V3& r, const V3& force) {
  HAZUMI_ASSERT(0 <= node && node < static_cast<int>(motion_.size()));
  if (!is_ball(node)) added_force_ += force;
  motion_[node].f -= force;
  motion_[node].n -= Cross(r, force);
}

void NodeKinematics::AddTorque(int node, const V3& torque) { motion_[node].n -= torque; }

void NodeKinematics::AddJointMoment(int node, const V3& moment) {
  HAZUMI_ASSERT(0 <= node && node < size());
  motion_[node].n -= moment;
  if (nodes_[node].parent >= 0) motion_[nodes_[node].parent].n += moment;
}

void NodeKinematics::ClearForces() {
  added_force_ = V3();
  for (NodeMotion& own : motion_) own.f = own.n = V3();
}

}  // namespace hazumi
