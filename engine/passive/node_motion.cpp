#include "engine/passive/node_motion.h"

#include <cmath>

// For every node i with parent p, with the accelerations of free hinges zero:
//   outwards  R, p, w, alpha, a of the node (as kinematics.h)
//   its body  f = m (a + alpha x c + w x (w x c)),  n = I alpha + w x I w + c x f

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// R := R Rot(axis, angle). About a coordinate axis only two columns change.
HAZUMI_INLINE void Turn(const NodeHinge& hinge, double angle, M3* R) {
  const double s = std::sin(angle), c = std::cos(angle);
  M3 was = *R;
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
      return R.a;
    case 1:
      return R.b;
    case 2:
      return R.c;
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

}  // namespace

NodeKinematics::NodeKinematics(const RegionModel& model)
    : R_root_(ToSmall(model.R_root)), motion_(model.nodes.size()) {
  for (const ModelNode& from : model.nodes) {
    Node node{from.parent,
              from.p_P,
              from.num_hinges,
              from.hinges,
              {},
              from.is_dynamic,
              from.body.is_massless(),
              from.body.mass,
              from.body.com,
              ToSymmetric(from.body.I_com)};
    for (int h = 0; h < from.num_hinges; ++h) node.axis[h] = from.hinges[h].axis;
    nodes_.push_back(node);
  }
}

void NodeKinematics::Move(const RegionLayout& layout, const DrivenMotion& driven, double t,
                          const double* positions, const double* velocities, int first, int last) {
  for (int i = first; i < last; ++i) {
    const Node& node = nodes_[i];
    NodeMotion& own = motion_[i];
    if (node.parent < 0) {
      own.R = R_root_;
      own.p = own.r = own.w = own.alpha = own.a = V3();
    } else {
      const NodeMotion& parent = motion_[node.parent];
      own.r = parent.R * node.p_P;
      own.R = parent.R;
      own.p = parent.p + own.r;
      own.w = parent.w;
      own.alpha = parent.alpha;
      own.a = parent.a + Cross(parent.alpha, own.r) + Cross(parent.w, Cross(parent.w, own.r));
    }
    using Kind = RegionLayout::NodeKind;
    const RegionLayout::Node& where = layout.node(i);
    if (where.kind == Kind::kBall) TurnBall(where, positions, velocities, &own);
    if (where.kind == Kind::kHinges) TurnHinges(node, where, positions, velocities, &own);
    if (where.kind == Kind::kDriven) TurnDriven(node, driven, t, &own);
  }
}

void NodeKinematics::TurnDriven(const Node& node, const DrivenMotion& driven, double t,
                                NodeMotion* own) const {
  for (int h = 0; h < node.num_hinges; ++h) {
    const Jet q = driven.angles[node.hinges[h].coordinate].At(t);
    const V3 axis = AxisOf(node.hinges[h], node.axis[h], own->R);
    own->alpha += q.dd * axis + q.d * Cross(own->w, axis);
    own->w += q.d * axis;
    Turn(node.hinges[h], q.v, &own->R);
  }
}

void NodeKinematics::TurnHinges(const Node& node, const RegionLayout::Node& layout,
                                const double* positions, const double* velocities,
                                NodeMotion* own) const {
  int free = 0;
  for (int h = 0; h < node.num_hinges; ++h) {
    if (layout.locked[h]) {
      Turn(node.hinges[h], layout.angle[h], &own->R);
      continue;
    }
    const double rate = velocities[layout.dof + free];
    const V3 axis = AxisOf(node.hinges[h], node.axis[h], own->R);
    own->axis[free] = axis;
    own->alpha += rate * Cross(own->w, axis);
    own->w += rate * axis;
    Turn(node.hinges[h], positions[layout.position + free], &own->R);
    ++free;
  }
}

void NodeKinematics::TurnBall(const RegionLayout::Node& layout, const double* positions,
                              const double* velocities, NodeMotion* own) const {
  own->R = own->R * FromQuaternion(positions + layout.position);
  own->axis = {own->R.a, own->R.b, own->R.c};
  const double* v = velocities + layout.dof;
  const V3 w = v[0] * own->R.a + v[1] * own->R.b + v[2] * own->R.c;
  own->alpha += Cross(own->w, w);
  own->w += w;
}

void NodeKinematics::Accelerate(const RegionLayout& layout, const double* x, int first) {
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

void NodeKinematics::SetOwnForces(const V3& base) {
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
    const V3 c = own.R * node.com;
    const S3 I = Rotated(own.R, node.I_com);
    const V3 wc = Cross(own.w, c);
    own.f = node.mass * (own.a + base + Cross(own.alpha, c) + Cross(own.w, wc));
    own.n = I * own.alpha + Cross(own.w, I * own.w) + Cross(c, own.f);
    own.h = node.mass * c;
    const double hc = Dot(own.h, c);
    own.I = {I.xx + hc - own.h.x * c.x, I.xy - own.h.x * c.y, I.xz - own.h.x * c.z,
             I.yy + hc - own.h.y * c.y, I.yz - own.h.y * c.z, I.zz + hc - own.h.z * c.z};
  }
}

}  // namespace hazumi
