// Propagation of impulses. With U = [I; H^T] s and D of a joint [articulated_bodies.cpp], an
// impulse (n, f) on its node and u about its hinges transmit to the origin of its parent
//   y = D^-1 (s.n + u),   n := n - UI y,   f := f - UF y,   n := n + r x f
// and a parent that moves with (w, v) at the node's origin moves the hinges by
//   x = y - D^-1 (UI.w + UF.v),   w := w + s x
// The response of a node to an impulse on it is R = Phi R_parent Phi^T + s D^-1 s^T, where Phi is
// the second rule with y = 0, and its transpose is the first rule with u = 0. A tour step from a
// node to its parent therefore transmits only the impulses added beyond the parent, and a step to a
// node only the motion of its parent.

#include "engine/region/equations/tree_impulses.h"

#include <algorithm>
#include <utility>

#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

double& Entry(V3* v, int k) { return k == 0 ? v->x : k == 1 ? v->y : v->z; }
double Entry(const V3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

V3 Unit(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

}  // namespace

TreeImpulses::TreeImpulses(const RegionModel& model)
    : ground_(static_cast<int>(model.nodes.size())),
      num_free_(model.num_free),
      joints_(model.nodes.size()) {
  for (size_t i = 0; i < joints_.size(); ++i) {
    const ModelNode& node = model.nodes[i];
    const bool is_carried = node.parent >= 0 && model.nodes[node.parent].is_dynamic;
    joints_[i].is_dynamic = node.is_dynamic;
    joints_[i].parent = is_carried ? node.parent : ground_;
  }
  ListTour();
  responses_.resize(joints_.size() + 1);
  total_.resize(joints_.size() + 1);
  pending_.resize(joints_.size() + 1);
  motion_.resize(joints_.size() + 1);
  about_hinges_.resize(joints_.size());
}

void TreeImpulses::ListTour() {
  std::vector<std::vector<int>> children(joints_.size() + 1);
  for (int i = ground_ - 1; i >= 0; --i) {  // reverse order: children are taken from the back
    if (joints_[i].is_dynamic) children[joints_[i].parent].push_back(i);
  }
  std::vector<int> path = {ground_};
  while (!path.empty()) {
    std::vector<int>& next = children[path.back()];
    if (next.empty()) {
      if (path.back() != ground_) tour_.push_back({path.back(), true});
      path.pop_back();
      continue;
    }
    path.push_back(next.back());
    next.pop_back();
    tour_.push_back({path.back(), false});
  }
}

void TreeImpulses::Begin(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                         const ArticulatedBodies& bodies) {
  responses_[ground_] = {{}, {}, bodies.RootResponse()};
  for (int i = 0; i < ground_; ++i) {
    Joint& joint = joints_[i];
    if (!joint.is_dynamic) continue;
    joint.dofs = layout.node(i).num_dofs;
    joint.dof = layout.node(i).dof;
    joint.r = joint.parent == ground_ ? V3() : motion[i].r;
    joint.axis = motion[i].axis;
    bodies.CopyJoint(i, &joint.UI, &joint.UF, &joint.D_inverse);
    FindResponse(i);
  }
}

// Computes the response column by column.
void TreeImpulses::FindResponse(int node) {
  const auto to = [&](const Impulse& impulse) {
    const Joint& joint = joints_[node];
    const Impulse passed = Passed(node, impulse, V3());
    return Carried(joint, AlongAxes(joint, impulse.n), ResponseTo(joint.parent, passed));
  };
  const Motion x = to({Unit(0), {}}), y = to({Unit(1), {}}), z = to({Unit(2), {}});
  const Motion a = to({{}, Unit(0)}), b = to({{}, Unit(1)}), c = to({{}, Unit(2)});
  responses_[node] = {{x.w.x, y.w.x, z.w.x, y.w.y, z.w.y, z.w.z},
                      {a.w, b.w, c.w},
                      {a.v.x, b.v.x, c.v.x, b.v.y, c.v.y, c.v.z}};
}

TreeImpulses::Motion TreeImpulses::ResponseTo(int node, const Impulse& impulse) const {
  const Response& response = responses_[node];
  return {response.of_turn * impulse.n + response.mixed * impulse.f,
          TransposeTimes(response.mixed, impulse.n) + response.of_shift * impulse.f};
}

double TreeImpulses::ResponseOfHinge(int node, int hinge) const {
  const Joint& joint = joints_[node];
  const Motion parent = ResponseTo(joint.parent, Passed(node, {}, Unit(hinge)));
  return Entry(RatesOf(joint, Unit(hinge), ParentAt(joint, parent)), hinge);
}

V3 TreeImpulses::AlongAxes(const Joint& joint, const V3& n) {
  V3 along;
  for (int k = 0; k < joint.dofs; ++k) Entry(&along, k) = Dot(joint.axis[k], n);
  return along;
}

// Motion of the parent at the node's origin.
TreeImpulses::Motion TreeImpulses::ParentAt(const Joint& joint, const Motion& parent) {
  return {parent.w, parent.v + Cross(parent.w, joint.r)};
}

TreeImpulses::Impulse TreeImpulses::Passed(int node, const Impulse& impulse,
                                           const V3& about_hinges) const {
  const Joint& joint = joints_[node];
  const V3 y = joint.D_inverse * (AlongAxes(joint, impulse.n) + about_hinges);
  Impulse passed = impulse;
  for (int k = 0; k < joint.dofs; ++k) {
    passed.n -= Entry(y, k) * joint.UI[k];
    passed.f -= Entry(y, k) * joint.UF[k];
  }
  passed.n += Cross(joint.r, passed.f);
  return passed;
}

// Rates of the hinges of a joint under the impulses `u` about them, with the motion `at` of the
// parent at the node's origin.
V3 TreeImpulses::RatesOf(const Joint& joint, V3 u, const Motion& at) {
  for (int k = 0; k < joint.dofs; ++k) {
    Entry(&u, k) -= Dot(joint.UI[k], at.w) + Dot(joint.UF[k], at.v);
  }
  return joint.D_inverse * u;
}

TreeImpulses::Motion TreeImpulses::Carried(const Joint& joint, const V3& u, const Motion& parent) {
  Motion motion = ParentAt(joint, parent);
  const V3 x = RatesOf(joint, u, motion);
  for (int k = 0; k < joint.dofs; ++k) motion.w += Entry(x, k) * joint.axis[k];
  return motion;
}

// Sum of the impulses on the node and beyond it, about the hinges of the node.
V3 TreeImpulses::TotalAbout(int node) const {
  return AlongAxes(joints_[node], total_[node].n) + about_hinges_[node];
}

void TreeImpulses::Clear() {
  std::fill(total_.begin(), total_.end(), Impulse());
  std::fill(pending_.begin(), pending_.end(), Impulse());
  std::fill(about_hinges_.begin(), about_hinges_.end(), V3());
}

void TreeImpulses::Add(int node, const Impulse& impulse) {
  HAZUMI_ASSERT(node == ground_ || is_dynamic(node));
  HAZUMI_ASSERT(IsFinite(impulse.f) && IsFinite(impulse.n));
  total_[node].n += impulse.n;
  total_[node].f += impulse.f;
}

void TreeImpulses::AddAboutHinge(int node, int hinge, double impulse) {
  HAZUMI_ASSERT(is_dynamic(node) && hinge < joints_[node].dofs);
  Entry(&about_hinges_[node], hinge) += impulse;
}

void TreeImpulses::Settle() {
  for (int i = ground_ - 1; i >= 0; --i) {
    if (joints_[i].is_dynamic) Add(joints_[i].parent, Passed(i, total_[i], about_hinges_[i]));
  }
  motion_[ground_] = ResponseTo(ground_, {{}, total_[ground_].f});
  for (int i = 0; i < ground_; ++i) {
    if (joints_[i].is_dynamic)
      motion_[i] = Carried(joints_[i], TotalAbout(i), motion_[joints_[i].parent]);
  }
}

void TreeImpulses::Take(const Step& step) {
  const Joint& joint = joints_[step.node];
  if (!step.up) {
    motion_[step.node] = Carried(joint, TotalAbout(step.node), motion_[joint.parent]);
    return;
  }
  Push(joint.parent, Passed(step.node, std::exchange(pending_[step.node], Impulse()), V3()));
}

void TreeImpulses::Push(int node, const Impulse& impulse) {
  Add(node, impulse);
  pending_[node].n += impulse.n;
  pending_[node].f += impulse.f;
  const Motion by = ResponseTo(node, impulse);
  motion_[node].w += by.w;
  motion_[node].v += by.v;
}

double TreeImpulses::Rate(int node, int hinge) const {
  HAZUMI_ASSERT(hinge < joints_[node].dofs);
  const Joint& joint = joints_[node];
  const Motion at = ParentAt(joint, motion_[joint.parent]);
  return Entry(RatesOf(joint, TotalAbout(node), at), hinge);
}

void TreeImpulses::PushHinge(int node, int hinge, double impulse) {
  HAZUMI_ASSERT(hinge < joints_[node].dofs);
  HAZUMI_ASSERT(std::isfinite(impulse));
  AddAboutHinge(node, hinge, impulse);
  Push(joints_[node].parent, Passed(node, {}, impulse * Unit(hinge)));
}

VecX TreeImpulses::Rates() const {
  VecX rates = VecX::Zero(num_free_);
  for (int i = 0; i < ground_; ++i) {
    const Joint& joint = joints_[i];
    if (!joint.is_dynamic) continue;
    const V3 x = RatesOf(joint, TotalAbout(i), ParentAt(joint, motion_[joint.parent]));
    for (int k = 0; k < joint.dofs; ++k) rates[joint.dof + k] = Entry(x, k);
  }
  return rates;
}

}  // namespace hazumi
