// On its way to the root a push leaves forces s.n at the joints and, in flight, f at the root's
// translation [articulated_push.cpp], which take them over with D^-1 and M^-1. What pushes k and l
// do to each other is
//   A_kl = sum (s.n)_k D^-1 (s.n)_l + f_k M^-1 f_l = (R^-1 J_k^T) . (R^-1 J_l^T)
// with D = L L^T and L^-1 s.n the entries of R^-1 J^T. By L, and not by D^-1, so that a body that
// turns about one axis much more easily than about the others keeps its digits there.

#include <cmath>

#include "engine/region/equations/articulated_bodies.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

// Directions that move no mass have no part in D^-1.
ArticulatedBodies::Triangle ArticulatedBodies::TriangleOf(const S3& D, const S3& D_inverse) {
  const auto inverse_root = [](double pivot, double of_inverse) {
    return of_inverse > 0.0 && pivot > 0.0 ? 1.0 / std::sqrt(pivot) : 0.0;
  };
  const double a = inverse_root(D.xx, D_inverse.xx), ab = a * D.xy, ac = a * D.xz;
  const double b = inverse_root(D.yy - ab * ab, D_inverse.yy), bc = b * (D.yz - ab * ac);
  const double c = inverse_root(D.zz - ac * ac - bc * bc, D_inverse.zz);
  return {a, b, c, ab, ac, bc};
}

V3 ArticulatedBodies::SolveLower(const Triangle& L, const V3& v) {
  const double x = L.inverse_a * v.x, y = L.inverse_b * (v.y - L.ab * x);
  return {x, y, L.inverse_c * (v.z - L.ac * x - L.bc * y)};
}

V3 ArticulatedBodies::SolveUpper(const Triangle& L, const V3& v) {
  const double z = L.inverse_c * v.z, y = L.inverse_b * (v.y - L.bc * z);
  return {L.inverse_a * (v.x - L.ab * y - L.ac * z), y, z};
}

void ArticulatedBodies::FactorJoints(const RegionLayout& layout,
                                     const std::vector<NodeMotion>& motion) {
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (!is_dynamic_[i]) continue;
    Body& body = bodies_[i];
    if (body.is_ball) {
      body.L = TriangleOf(body.I, body.D_inverse);
      continue;
    }
    const int dofs = layout.node(static_cast<int>(i)).num_dofs;
    const auto entry = [&](int k, int l) {
      return l < dofs ? Dot(motion[i].axis[k], body.UI[l]) : 0.0;
    };
    const S3 D{entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
    body.L = TriangleOf(D, dofs > 0 ? body.D_inverse : S3());
  }
  if (root_flies_) L_root_ = TriangleOf(bodies_[0].M, Diagonal(1.0));
}

void ArticulatedBodies::AddHalf(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                                int node, const V3& r, const V3& force, bool turns,
                                double* half) const {
  if (!is_dynamic_[node]) return;
  V3 n = turns ? force : Cross(r, force), f = turns ? V3() : force;
  for (int i = node;; i = parents_[i]) {
    const Body& body = bodies_[i];
    const RegionLayout::Node& where = layout.node(i);
    V3 s = n;
    if (!body.is_ball) {
      double of_axes[3] = {0.0, 0.0, 0.0};
      for (int k = 0; k < where.num_dofs; ++k) of_axes[k] = Dot(motion[i].axis[k], n);
      s = {of_axes[0], of_axes[1], of_axes[2]};
    }
    const V3 own = SolveLower(body.L, s);
    const double entries[3] = {own.x, own.y, own.z};
    for (int k = 0; k < where.num_dofs; ++k) half[num_root() + where.dof + k] += entries[k];
    if (is_base_[i]) return;
    const V3 taken = SolveUpper(body.L, own);
    if (body.is_ball) {
      f -= TransposeTimes(body.H, taken);
    } else {
      const double y[3] = {taken.x, taken.y, taken.z};
      for (int k = 0; k < where.num_dofs; ++k) {
        f -= y[k] * body.UF[k];
        n -= y[k] * body.UI[k];
      }
    }
    if (where.num_dofs == 3) n = V3();
    if (parents_[i] < 0) break;
    n += Cross(motion[i].r, f);
  }
  const V3 own = SolveLower(L_root_, f);
  half[0] += own.x;
  half[1] += own.y;
  half[2] += own.z;
}

// With the same L from the root on, so that what a point gets is what the halves' products say:
//   y = L^-T (half - L^-1 (what the joint's parent takes along)).
void ArticulatedBodies::FinishHalf(const RegionLayout& layout,
                                   const std::vector<NodeMotion>& motion, const double* half,
                                   double* x) {
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    if (!is_dynamic_[i]) continue;
    Body& body = bodies_[i];
    if (parents_[i] >= 0) {
      const Body& parent = bodies_[parents_[i]];
      body.dalpha = parent.dalpha;
      body.da = parent.da + Cross(parent.dalpha, motion[i].r);
    } else {
      body.dalpha = V3();
      body.da = root_flies_ ? SolveUpper(L_root_, {half[0], half[1], half[2]}) : V3();
    }
    const RegionLayout::Node& where = layout.node(i);
    double own[3] = {0.0, 0.0, 0.0}, taken[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < where.num_dofs; ++k) {
      own[k] = half[num_root() + where.dof + k];
      if (is_base_[i] || body.is_ball) continue;
      taken[k] = Dot(body.UI[k], body.dalpha) + Dot(body.UF[k], body.da);
    }
    V3 along{taken[0], taken[1], taken[2]};
    if (body.is_ball && !is_base_[i]) along = body.H * body.da;
    V3 y = SolveUpper(body.L, V3{own[0], own[1], own[2]} - SolveLower(body.L, along));
    if (body.is_ball) {
      const V3 turn = y - body.dalpha;
      body.dalpha = y;
      y = TransposeTimes(motion[i].R, turn);
    }
    const double entries[3] = {y.x, y.y, y.z};
    for (int k = 0; k < where.num_dofs; ++k) {
      x[where.dof + k] = entries[k];
      if (!body.is_ball) body.dalpha += entries[k] * motion[i].axis[k];
    }
  }
}

}  // namespace hazumi
