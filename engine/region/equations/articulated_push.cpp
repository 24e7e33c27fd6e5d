// A force on a point of bodies whose joints have been eliminated: with the inertias as they are,
// what it asks for passes on as n0 and f0 do [articulated_bodies.h],
//   y = D^-1 (tau - s.n),   n := n + I s y,   f := f + H^T s y
// and through the joint to its parent; then the accelerations follow from the root on. tau: of the
// joint, if that is what is asked for.

#include "engine/region/equations/articulated_bodies.h"
#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

// What joints that follow freely pass on of a push, without the inertias, which are as they were.
void ArticulatedBodies::PassPush(int i, const RegionLayout& layout, const NodeMotion& motion) {
  Body& body = bodies_[i];
  const int dofs = layout.node(i).num_dofs;
  if (body.is_ball) {
    body.y = -(body.D_inverse * body.n);
    body.f += TransposeTimes(body.H, body.y);
  } else {
    double u[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < dofs; ++k) u[k] = -Dot(motion.axis[k], body.n);
    if (i == twisted_node_) u[twisted_dof_] += 1.0;
    body.y = body.D_inverse * V3{u[0], u[1], u[2]};
    const double y[3] = {body.y.x, body.y.y, body.y.z};
    for (int k = 0; k < dofs; ++k) {
      body.f += y[k] * body.UF[k];
      body.n += y[k] * body.UI[k];
    }
  }
  if (parents_[i] < 0) return;
  Body& to = bodies_[parents_[i]];
  to.f += body.f;
  to.n += Cross(motion.r, body.f);
  if (dofs < 3 || i == twisted_node_) to.n += body.n;
}

void ArticulatedBodies::Push(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                             int node, const V3& r, const V3& force, double* x) {
  for (Body& body : bodies_) body.n = body.f = V3();
  bodies_[node].f = -force;
  bodies_[node].n = -Cross(r, force);
  Pass(layout, motion, x);
}

void ArticulatedBodies::Twist(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              int node, int dof, double* x) {
  for (Body& body : bodies_) body.n = body.f = V3();
  twisted_node_ = node;
  twisted_dof_ = dof;
  Pass(layout, motion, x);
  twisted_node_ = -1;
}

// Every body asks for what moves it along: f0 = m a, n0 = h x a.
void ArticulatedBodies::Shake(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                              const V3& acceleration, double* x) {
  for (size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].n = is_dynamic_[i] ? Cross(motion[i].h, acceleration) : V3();
    bodies_[i].f = is_dynamic_[i] ? motion[i].m * acceleration : V3();
  }
  Pass(layout, motion, x);
}

void ArticulatedBodies::Pass(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                             double* x) {
  for (int i = static_cast<int>(bodies_.size()) - 1; i >= 0; --i) {
    if (is_dynamic_[i]) PassPush(i, layout, motion[i]);
  }
  Distribute(layout, motion, x);
}

void ArticulatedBodies::CopyJoint(int node, std::array<V3, 3>* UI, std::array<V3, 3>* UF,
                                  S3* D_inverse) const {
  const Body& body = bodies_[node];
  *UI = is_base_[node] ? std::array<V3, 3>() : body.UI;
  *UF = is_base_[node] ? std::array<V3, 3>() : body.UF;
  *D_inverse = body.D_inverse;
}

V3 ArticulatedBodies::AccelerationAt(int node, const V3& r) const {
  HAZUMI_ASSERT(0 <= node && node < static_cast<int>(bodies_.size()));
  return bodies_[node].da + Cross(bodies_[node].dalpha, r);
}

}  // namespace hazumi
