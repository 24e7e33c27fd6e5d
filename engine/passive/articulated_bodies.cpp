#include "engine/passive/articulated_bodies.h"

#include <cmath>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

constexpr double kLost = 1e-13;  // what rounding leaves of a moment of inertia that is zero

// A pseudo-inverse where rows and columns that move no mass are zero, pivots in order.
S3 CarefulInverse(const S3& D, double least) {
  const double i1 = D.xx > least ? 1.0 / D.xx : 0.0;
  const double l2 = i1 * D.xy, l3 = i1 * D.xz;
  const double d2 = D.yy - l2 * D.xy;
  const double i2 = d2 > least ? 1.0 / d2 : 0.0;
  const double e = D.yz - l3 * D.xy;
  const double l32 = i2 * e;
  const double d3 = D.zz - l3 * D.xz - l32 * e;
  const double i3 = d3 > least ? 1.0 / d3 : 0.0;
  // L^-1 = (1, 0, 0; -l2, 1, 0; l2 l32 - l3, -l32, 1);  D^-1 = L^-T diag(i) L^-1
  const double m31 = l2 * l32 - l3;
  return {i1 + l2 * l2 * i2 + m31 * m31 * i3,
          -l2 * i2 - l32 * m31 * i3,
          m31 * i3,
          i2 + l32 * l32 * i3,
          -l32 * i3,
          i3};
}

// By cofactors, which takes one division, unless that would lose digits.
HAZUMI_INLINE S3 Inverse(const S3& D, double size) {
  const double cxx = D.yy * D.zz - D.yz * D.yz;
  const double cxy = D.xz * D.yz - D.xy * D.zz;
  const double cxz = D.xy * D.yz - D.xz * D.yy;
  const double det = D.xx * cxx + D.xy * cxy + D.xz * cxz;
  if (!(det > 1e-9 * size * size * size)) return CarefulInverse(D, kLost * size);
  const double k = 1.0 / det;
  return {k * cxx,
          k * cxy,
          k * cxz,
          k * (D.xx * D.zz - D.xz * D.xz),
          k * (D.xy * D.xz - D.xx * D.yz),
          k * (D.xx * D.yy - D.xy * D.xy)};
}

// The solution of S x = v for a positive definite S.
V3 Solve3(const S3& S, const V3& v) { return CarefulInverse(S, 0.0) * v; }

}  // namespace

ArticulatedBodies::ArticulatedBodies(const RegionModel& model) : bodies_(model.nodes.size()) {
  for (const ModelNode& node : model.nodes) {
    const bool carried = node.parent >= 0 && model.nodes[node.parent].is_dynamic;
    parents_.push_back(carried ? node.parent : -1);
    is_dynamic_.push_back(node.is_dynamic);
  }
}

template <int kDofs>
HAZUMI_INLINE void ArticulatedBodies::SolveJoint(const NodeMotion& motion, Body* body) const {
  for (int k = 0; k < kDofs; ++k) {
    body->UI[k] = body->I * motion.axis[k];
    body->UF[k] = TransposeTimes(body->H, motion.axis[k]);
  }
  const double size = body->I.xx + body->I.yy + body->I.zz;
  const double d11 = Dot(motion.axis[0], body->UI[0]);
  const double u1 = -Dot(motion.axis[0], body->n);
  S3& inverse = body->D_inverse;
  if constexpr (kDofs == 1) {
    inverse = {d11 > kLost * size ? 1.0 / d11 : 0.0, 0, 0, 0, 0, 0};
    body->y = {inverse.xx * u1, 0, 0};
    return;
  }
  const double d12 = Dot(motion.axis[0], body->UI[1]), d22 = Dot(motion.axis[1], body->UI[1]);
  const double u2 = -Dot(motion.axis[1], body->n);
  if constexpr (kDofs == 2) {
    const double det = d11 * d22 - d12 * d12;
    if (det > 1e-9 * size * size) {
      const double k = 1.0 / det;
      inverse = {k * d22, -k * d12, 0, k * d11, 0, 0};
    } else {
      inverse = CarefulInverse({d11, d12, 0, d22, 0, 0}, kLost * size);
    }
    body->y = {inverse.xx * u1 + inverse.xy * u2, inverse.xy * u1 + inverse.yy * u2, 0};
    return;
  }
  if constexpr (kDofs == 3) {
    const double u3 = -Dot(motion.axis[2], body->n);
    inverse = Inverse({d11, d12, Dot(motion.axis[0], body->UI[2]), d22,
                       Dot(motion.axis[1], body->UI[2]), Dot(motion.axis[2], body->UI[2])},
                      size);
    body->y = inverse * V3{u1, u2, u3};
  }
}

// What is left of the body for its parent, once the joint follows freely. A ball joint passes on no
// moment.
template <int kDofs>
HAZUMI_INLINE void ArticulatedBodies::Reduce(Body* body) const {
  const double y[3] = {body->y.x, body->y.y, body->y.z};
  const S3& D = body->D_inverse;
  const double row[3][3] = {{D.xx, D.xy, D.xz}, {D.xy, D.yy, D.yz}, {D.xz, D.yz, D.zz}};
  for (int k = 0; k < kDofs; ++k) {
    V3 VI = row[k][0] * body->UI[0], VF = row[k][0] * body->UF[0];
    for (int l = 1; l < kDofs; ++l) {
      VI += row[k][l] * body->UI[l];
      VF += row[k][l] * body->UF[l];
    }
    body->f += y[k] * body->UF[k];
    SubtractOuter(body->M, body->UF[k], VF);
    if constexpr (kDofs == 3) continue;
    body->n += y[k] * body->UI[k];
    SubtractOuter(body->I, body->UI[k], VI);
    SubtractOuter(body->H, body->UI[k], VF);
  }
  if constexpr (kDofs == 3) body->n = V3();
}

template <int kDofs>
HAZUMI_INLINE void ArticulatedBodies::Eliminate(int i, const NodeMotion& motion, bool root_flies) {
  Body& body = bodies_[i];
  if constexpr (kDofs > 0) SolveJoint<kDofs>(motion, &body);
  const int parent = parents_[i];
  if (parent < 0 && !root_flies) return;
  if constexpr (kDofs > 0) Reduce<kDofs>(&body);
  if (parent >= 0) PassToParent<kDofs == 3>(motion.r, body, &bodies_[parent]);
}

// With a_c = a_p - [r] alpha:  M, H + [r] M, I - H [r] + [r] (H + [r] M)^T about the parent's
// origin.
template <bool kIsFreeOfMoment>
HAZUMI_INLINE void ArticulatedBodies::PassToParent(const V3& r, const Body& from, Body* to) const {
  to->f += from.f;
  to->n += from.n + Cross(r, from.f);
  to->M += from.M;
  const S3& M = from.M;
  M3 Hs{Cross(r, {M.xx, M.xy, M.xz}), Cross(r, {M.xy, M.yy, M.yz}), Cross(r, {M.xz, M.yz, M.zz})};
  if constexpr (!kIsFreeOfMoment) Hs += from.H;
  to->H += Hs;
  // Columns of Hs [r].
  const V3 a = r.z * Hs.b - r.y * Hs.c, b = r.x * Hs.c - r.z * Hs.a, c = r.y * Hs.a - r.x * Hs.b;
  if constexpr (kIsFreeOfMoment) {
    to->I += S3{-a.x, -b.x, -c.x, -b.y, -c.y, -c.z};
    return;
  }
  const M3& H = from.H;
  const V3 d = r.z * H.b - r.y * H.c, e = r.x * H.c - r.z * H.a, g = r.y * H.a - r.x * H.b;
  to->I += from.I;
  to->I += S3{-d.x - a.x, -e.x - a.y, -g.x - a.z, -e.y - b.y, -g.y - b.z, -g.z - c.z};
}

void ArticulatedBodies::Accelerate(const RegionLayout::Node& layout, const NodeMotion& motion,
                                   Body* body, double* x) const {
  double u[3] = {0.0, 0.0, 0.0};
  for (int k = 0; k < layout.num_dofs; ++k) {
    u[k] = Dot(body->UI[k], body->dalpha) + Dot(body->UF[k], body->da);
  }
  const V3 change = body->D_inverse * V3{u[0], u[1], u[2]};
  const double solved[3] = {body->y.x - change.x, body->y.y - change.y, body->y.z - change.z};
  for (int k = 0; k < layout.num_dofs; ++k) {
    x[layout.dof + k] = solved[k];
    body->dalpha += solved[k] * motion.axis[k];
  }
}

void ArticulatedBodies::Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              bool root_flies, double* x) {
  const int count = static_cast<int>(bodies_.size());
  for (int i = 0; i < count; ++i) {
    if (!is_dynamic_[i]) continue;
    const NodeMotion& own = motion[i];
    Body& body = bodies_[i];
    body.I = own.I;
    body.H = {{0.0, own.h.z, -own.h.y}, {-own.h.z, 0.0, own.h.x}, {own.h.y, -own.h.x, 0.0}};
    body.M = Diagonal(own.m);
    body.n = own.n;
    body.f = own.f;
  }
  for (int i = count - 1; i >= 0; --i) {
    if (!is_dynamic_[i]) continue;
    switch (layout.node(i).num_dofs) {
      case 0:
        Eliminate<0>(i, motion[i], root_flies);
        break;
      case 1:
        Eliminate<1>(i, motion[i], root_flies);
        break;
      case 2:
        Eliminate<2>(i, motion[i], root_flies);
        break;
      default:
        Eliminate<3>(i, motion[i], root_flies);
    }
  }
  for (int i = 0; i < count; ++i) {
    if (!is_dynamic_[i]) continue;
    Body& body = bodies_[i];
    if (parents_[i] >= 0) {
      const Body& parent = bodies_[parents_[i]];
      body.dalpha = parent.dalpha;
      body.da = parent.da + Cross(parent.dalpha, motion[i].r);
    } else {
      body.dalpha = V3();
      body.da = root_flies ? -Solve3(body.M, body.f) : V3();
    }
    Accelerate(layout.node(i), motion[i], &body, x);
  }
}

}  // namespace hazumi
