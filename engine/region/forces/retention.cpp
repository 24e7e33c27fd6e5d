// Hinges:  v' = x - c v,  x what the forces give, c a hinge's rate.
// Balls of one rate:  w' = x - c w.  Of several, with mean m and rates of hinges s from A(q) s = w:
//   w' = x - m w - f(d) A(q) (c - m) s
// for the hinges' rates have no bound at the pole: f rises from 0 at the pole to 1 at 10 degrees
// from it, with two derivatives, d being the distance. [METHOD 2.5]

#include "engine/region/forces/retention.h"

#include <algorithm>

#include "engine/spatial/degrees.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

double Retention::FastestRate() const { return rates_.size() > 0 ? rates_.maxCoeff() : 0.0; }

void Retention::AddAccelerations(const RegionState& state, double* x) const {
  const auto& nodes = state.layout.nodes();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    if (nodes[i].kind == RegionLayout::NodeKind::kHinges) AddOfHinges(state, nodes[i], x);
    if (nodes[i].kind == RegionLayout::NodeKind::kBall) AddOfBall(state, i, x);
  }
}

void Retention::AddOfHinges(const RegionState& state, const RegionLayout::Node& node,
                            double* x) const {
  const double* v = state.velocities + node.dof;
  for (int h = 0, free = 0; free < node.num_dofs; ++h) {
    if (node.locked[h]) continue;
    x[node.dof + free] += -rates_[node.first_hinge + h] * v[free];
    ++free;
  }
}

void Retention::AddOfBall(const RegionState& state, int node, double* x) const {
  constexpr double kFar = 10.0 * kDegree;
  const RegionLayout::Node& own = state.layout.node(node);
  const Vec3 c = rates_.segment<3>(own.first_hinge);
  const Eigen::Map<const Vec3> w_B(state.velocities + own.dof);
  Eigen::Map<Vec3> to(x + own.dof);
  const double mean = c.mean();
  Vec3 sum = -mean * w_B;
  if (c[0] != c[1] || c[1] != c[2]) {
    const HingeTriple& triple = *state.layout.triple(node);
    const Mat3 R = RotationOfQuaternion(state.positions + own.position);
    const Vec3 q = triple.Angles(R, Vec3::Zero(), false);
    const double s = std::min(1.0, triple.FromPole(q[1]) / kFar);
    const double weight = SmoothStep(s);
    if (weight != 0.0) {
      const Vec3 rates = triple.Rates(q, w_B);
      sum -= weight * (triple.AxesInBody(q) * Vec3((c.array() - mean) * rates.array()));
    }
  }
  to += sum;
}

}  // namespace hazumi
