#include "engine/region/equations/articulated_bodies.h"

#include <cmath>

#include "engine/spatial/checks.h"

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

// By cofactors, which takes one division; false if that would lose digits.
HAZUMI_INLINE bool InvertRegular(const S3& D, double size, S3* inverse) {
  const double cxx = D.yy * D.zz - D.yz * D.yz;
  const double cxy = D.xz * D.yz - D.xy * D.zz;
  const double cxz = D.xy * D.yz - D.xz * D.yy;
  const double det = D.xx * cxx + D.xy * cxy + D.xz * cxz;
  if (!(det > 1e-9 * size * size * size)) return false;
  const double k = 1.0 / det;
  *inverse = {k * cxx,
              k * cxy,
              k * cxz,
              k * (D.xx * D.zz - D.xz * D.xz),
              k * (D.xy * D.xz - D.xx * D.yz),
              k * (D.xx * D.yy - D.xy * D.xy)};
  return true;
}

// The solution of S x = v for a positive definite S.
V3 Solve3(const S3& S, const V3& v) { return CarefulInverse(S, 0.0) * v; }

}  // namespace

ArticulatedBodies::ArticulatedBodies(const RegionModel& model)
    : root_flies_(model.root_answers), bodies_(model.nodes.size()) {
  for (const ModelNode& node : model.nodes) {
    const bool carried = node.parent >= 0 && model.nodes[node.parent].is_dynamic;
    parents_.push_back(carried ? node.parent : -1);
    is_base_.push_back(!carried && !root_flies_);
    is_dynamic_.push_back(node.is_dynamic);
  }
}

// [I; H^T] s for every direction s, D, and what the joint does while nothing carries it away. Where
// it never is, the forces of s are not needed.
template <int kDofs, bool kIsBase>
HAZUMI_INLINE void ArticulatedBodies::SolveJoint(const NodeMotion& motion, Body* body) const {
  for (int k = 0; k < kDofs; ++k) {
    body->UI[k] = body->I * motion.axis[k];
    if constexpr (!kIsBase) body->UF[k] = TransposeTimes(body->H, motion.axis[k]);
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
    const S3 D{d11,
               d12,
               Dot(motion.axis[0], body->UI[2]),
               d22,
               Dot(motion.axis[1], body->UI[2]),
               Dot(motion.axis[2], body->UI[2])};
    if (!InvertRegular(D, size, &inverse)) inverse = CarefulInverse(D, kLost * size);
    body->y = inverse * V3{u1, u2, u3};
  }
}

// What is left of the body for its parent, once the joint follows freely. Three directions pass on
// no moment.
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
}

template <int kDofs>
HAZUMI_INLINE void ArticulatedBodies::Eliminate(int i, const NodeMotion& motion) {
  Body& body = bodies_[i];
  body.is_ball = false;
  if (is_base_[i]) {
    if constexpr (kDofs > 0) SolveJoint<kDofs, true>(motion, &body);
    return;
  }
  if constexpr (kDofs > 0) {
    SolveJoint<kDofs, false>(motion, &body);
    Reduce<kDofs>(&body);
  }
  PassToParent<kDofs == 3>(i, motion.r);
}

// A ball joint needs no axes: without a moment on it the body's angular acceleration beta follows
// from I beta + H da + n = 0, whatever carries it. Where beta is not determined, or nearly, the
// axes have to say what stays zero.
HAZUMI_INLINE void ArticulatedBodies::EliminateBall(int i, const NodeMotion& motion) {
  Body& body = bodies_[i];
  S3 inverse;
  if (!InvertRegular(body.I, body.I.xx + body.I.yy + body.I.zz, &inverse)) {
    return Eliminate<3>(i, motion);
  }
  body.is_ball = true;
  body.D_inverse = inverse;
  body.y = -(inverse * body.n);
  if (is_base_[i]) return;
  const M3& H = body.H;
  body.K = {inverse * H.a, inverse * H.b, inverse * H.c};
  body.f += TransposeTimes(H, body.y);
  S3& M = body.M;
  M.xx -= Dot(H.a, body.K.a);
  M.xy -= Dot(H.a, body.K.b);
  M.xz -= Dot(H.a, body.K.c);
  M.yy -= Dot(H.b, body.K.b);
  M.yz -= Dot(H.b, body.K.c);
  M.zz -= Dot(H.c, body.K.c);
  PassToParent<true>(i, motion.r);
}

// With a_c = a_p - [r] alpha:  M, H + [r] M, I - H [r] + [r] (H + [r] M)^T about the parent's
// origin.
template <bool kIsFreeOfMoment>
HAZUMI_INLINE void ArticulatedBodies::PassToParent(int i, const V3& r) {
  if (parents_[i] < 0) return;
  const Body& from = bodies_[i];
  Body& to = bodies_[parents_[i]];
  const S3& M = from.M;
  M3 Hs{Cross(r, {M.xx, M.xy, M.xz}), Cross(r, {M.xy, M.yy, M.yz}), Cross(r, {M.xz, M.yz, M.zz})};
  if constexpr (!kIsFreeOfMoment) Hs += from.H;
  to.n += Cross(r, from.f);
  if constexpr (!kIsFreeOfMoment) to.n += from.n;
  if (!is_base_[parents_[i]]) {
    to.f += from.f;
    to.M += M;
    to.H += Hs;
  }
  // Columns of Hs [r].
  const V3 a = r.z * Hs.b - r.y * Hs.c, b = r.x * Hs.c - r.z * Hs.a, c = r.y * Hs.a - r.x * Hs.b;
  if constexpr (kIsFreeOfMoment) {
    to.I += S3{-a.x, -b.x, -c.x, -b.y, -c.y, -c.z};
    return;
  }
  const M3& H = from.H;
  const V3 d = r.z * H.b - r.y * H.c, e = r.x * H.c - r.z * H.a, g = r.y * H.a - r.x * H.b;
  to.I += from.I;
  to.I += S3{-d.x - a.x, -e.x - a.y, -g.x - a.z, -e.y - b.y, -g.y - b.z, -g.z - c.z};
}

template <int kDofs>
HAZUMI_INLINE void ArticulatedBodies::Accelerate(int i, const NodeMotion& motion, double* x) {
  if constexpr (kDofs == 0) return;
  Body& body = bodies_[i];
  V3 solved = body.y;
  if (!is_base_[i]) {
    double u[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < kDofs; ++k) {
      u[k] = Dot(body.UI[k], body.dalpha) + Dot(body.UF[k], body.da);
    }
    solved -= body.D_inverse * V3{u[0], u[1], u[2]};
  }
  const double entries[3] = {solved.x, solved.y, solved.z};
  for (int k = 0; k < kDofs; ++k) {
    x[k] = entries[k];
    body.dalpha += entries[k] * motion.axis[k];
  }
}

HAZUMI_INLINE void ArticulatedBodies::AccelerateBall(int i, const NodeMotion& motion, double* x) {
  Body& body = bodies_[i];
  const V3 beta = is_base_[i] ? body.y : body.y - body.K * body.da;
  const V3 solved = TransposeTimes(motion.R, beta - body.dalpha);
  x[0] = solved.x;
  x[1] = solved.y;
  x[2] = solved.z;
  body.dalpha = beta;
}

HAZUMI_INLINE void ArticulatedBodies::MoveWithParent(int i, const V3& r) {
  Body& body = bodies_[i];
  if (parents_[i] >= 0) {
    const Body& parent = bodies_[parents_[i]];
    body.dalpha = parent.dalpha;
    body.da = parent.da + Cross(parent.dalpha, r);
  } else {
    body.dalpha = V3();
    body.da = root_flies_ ? -Solve3(body.M, body.f) : V3();
  }
}

S3 ArticulatedBodies::RootResponse() const {
  return root_flies_ ? CarefulInverse(bodies_[0].M, 0.0) : S3();
}

void ArticulatedBodies::Begin(const std::vector<NodeMotion>& motion) {
  HAZUMI_ASSERT(motion.size() >= bodies_.size());
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (!is_dynamic_[i]) continue;
    const NodeMotion& own = motion[i];
    Body& body = bodies_[i];
    body.I = own.I;
    body.n = own.n;
    if (is_base_[i]) continue;
    body.H = {{0.0, own.h.z, -own.h.y}, {-own.h.z, 0.0, own.h.x}, {own.h.y, -own.h.x, 0.0}};
    body.M = Diagonal(own.m);
    body.f = own.f;
  }
}

void ArticulatedBodies::Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              double* x) {
  const int count = static_cast<int>(bodies_.size());
  Begin(motion);
  for (int i = count - 1; i >= 0; --i) {
    if (!is_dynamic_[i]) continue;
    if (layout.node(i).kind == RegionLayout::NodeKind::kBall) {
      EliminateBall(i, motion[i]);
      continue;
    }
    switch (layout.node(i).num_dofs) {
      case 0:
        Eliminate<0>(i, motion[i]);
        break;
      case 1:
        Eliminate<1>(i, motion[i]);
        break;
      case 2:
        Eliminate<2>(i, motion[i]);
        break;
      default:
        Eliminate<3>(i, motion[i]);
    }
  }
  Distribute(layout, motion, x);
}

void ArticulatedBodies::Distribute(const RegionLayout& layout,
                                   const std::vector<NodeMotion>& motion, double* x) {
  const int count = static_cast<int>(bodies_.size());
  for (int i = 0; i < count; ++i) {
    if (!is_dynamic_[i]) continue;
    MoveWithParent(i, motion[i].r);
    double* own = x + layout.node(i).dof;
    switch (layout.node(i).num_dofs) {
      case 0:
        break;
      case 1:
        Accelerate<1>(i, motion[i], own);
        break;
      case 2:
        Accelerate<2>(i, motion[i], own);
        break;
      default:
        bodies_[i].is_ball ? AccelerateBall(i, motion[i], own) : Accelerate<3>(i, motion[i], own);
    }
  }
}

}  // namespace hazumi
