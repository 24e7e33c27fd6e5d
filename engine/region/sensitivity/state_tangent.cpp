// Ball joint of three hinges with axes a_i (columns of A), all in the turned body's frame:
//   turn = A dq,    w = A q',    dw = A dq' + B dq,    B_j = sum_{i<j} q'_i a_i x a_j,
// since a turn by the later hinge j changes a_i by dq_j a_i x a_j.

#include "engine/region/sensitivity/state_tangent.h"

#include <Eigen/LU>

namespace hazumi {

namespace {

constexpr double kPoleOfTangent = 1e-7;  // [rad]

struct BallTangent {
  Mat3 A, B;
};

BallTangent TangentOf(const HingeTriple& ball, const Vec3& q, const Vec3& qd) {
  BallTangent tangent{ball.AxesInBody(q), Mat3::Zero()};
  for (int j = 1; j < 3; ++j) {
    for (int i = 0; i < j; ++i) {
      tangent.B.col(j) += qd[i] * tangent.A.col(i).cross(tangent.A.col(j));
    }
  }
  return tangent;
}

// Calls action(hinge, dof) for each free hinge that is neither locked nor of a ball joint.
template <typename Action>
void ForEachSingleHinge(const RegionLayout& layout, Action&& action) {
  int dof = -1, node_before = -1;
  for (int i = 0; i < layout.num_hinges(); ++i) {
    const FreeHinge& hinge = layout.hinges()[static_cast<size_t>(i)];
    const RegionLayout::Node& node = layout.node(hinge.node);
    if (hinge.node != node_before) dof = node.dof;
    node_before = hinge.node;
    const bool is_locked = node.locked[static_cast<size_t>(hinge.slot)];
    if (node.kind != RegionLayout::NodeKind::kHinges || is_locked) continue;
    action(i, dof++);
  }
}

// Calls action(ball, first hinge, first dof) for each ball joint.
template <typename Action>
void ForEachBall(const RegionLayout& layout, Action&& action) {
  for (int i = 0; i < static_cast<int>(layout.nodes().size()); ++i) {
    const HingeTriple* ball = layout.triple(i);
    if (ball) action(*ball, layout.node(i).first_hinge, layout.node(i).dof);
  }
}

}  // namespace

MatX DofsFromHinges(const RegionLayout& layout, const VecX& q, const VecX& qd) {
  const int n = layout.num_hinges(), m = layout.num_dofs();
  MatX T = MatX::Zero(2 * m, 2 * n);
  ForEachSingleHinge(layout, [&](int hinge, int dof) {
    T(dof, hinge) = 1.0;
    T(m + dof, n + hinge) = 1.0;
  });
  ForEachBall(layout, [&](const HingeTriple& ball, int hinge, int dof) {
    const BallTangent tangent = TangentOf(ball, q.segment<3>(hinge), qd.segment<3>(hinge));
    T.block<3, 3>(dof, hinge) = tangent.A;
    T.block<3, 3>(m + dof, hinge) = tangent.B;
    T.block<3, 3>(m + dof, n + hinge) = tangent.A;
  });
  return T;
}

std::optional<MatX> HingesFromDofs(const RegionLayout& layout, const VecX& q, const VecX& qd) {
  const int n = layout.num_hinges(), m = layout.num_dofs();
  MatX T = MatX::Zero(2 * n, 2 * m);
  ForEachSingleHinge(layout, [&](int hinge, int dof) {
    T(hinge, dof) = 1.0;
    T(n + hinge, m + dof) = 1.0;
  });
  bool is_at_pole = false;
  ForEachBall(layout, [&](const HingeTriple& ball, int hinge, int dof) {
    is_at_pole |= ball.FromPole(q[hinge + 1]) < kPoleOfTangent;
    const BallTangent tangent = TangentOf(ball, q.segment<3>(hinge), qd.segment<3>(hinge));
    const Mat3 inverse = tangent.A.inverse();
    T.block<3, 3>(hinge, dof) = inverse;
    T.block<3, 3>(n + hinge, dof) = -inverse * tangent.B * inverse;
    T.block<3, 3>(n + hinge, m + dof) = inverse;
  });
  if (is_at_pole) return std::nullopt;
  return T;
}

}  // namespace hazumi
