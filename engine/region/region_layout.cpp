#include "engine/region/region_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

constexpr double kWithoutLimit = std::numeric_limits<double>::infinity();

}  // namespace

Mat3 RotationOfQuaternion(const double* q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double s = 2.0 / (w * w + x * x + y * y + z * z);
  Mat3 R;
  R << 1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y);
  return R;
}

RegionLayout::RegionLayout(const RegionModel& model, bool balls)
    : num_hinges_of_(model.nodes.size(), 0),
      triple_of_(model.nodes.size(), -1),
      nodes_(model.nodes.size()) {
  hinges_.reserve(static_cast<size_t>(model.num_free));
  for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
    const ModelNode& node = model.nodes[i];
    if (node.role != Role::kFree) {
      if (node.num_hinges > 0) nodes_[i].kind = NodeKind::kDriven;
      continue;
    }
    nodes_[i].first_hinge = num_hinges();
    num_hinges_of_[i] = node.num_hinges;
    for (int h = 0; h < node.num_hinges; ++h) hinges_.push_back({node.hinges[h].coordinate, i, h});
    if (!node.is_ball || !balls) continue;
    triple_of_[i] = static_cast<int>(triples_.size());
    triples_.emplace_back(node.hinges[0].axis, node.hinges[1].axis, node.hinges[2].axis);
  }
  angles_.reserve(num_hinges());
  SetLocked(std::vector<char>(num_hinges(), 0), VecX::Zero(num_hinges()));
}

const HingeTriple* RegionLayout::triple(int node) const {
  return nodes_[node].kind == NodeKind::kBall ? unlocked_triple(node) : nullptr;
}

const HingeTriple* RegionLayout::unlocked_triple(int node) const {
  return triple_of_[node] >= 0 ? &triples_[triple_of_[node]] : nullptr;
}

void RegionLayout::SetLocked(const std::vector<char>& locked, const VecX& angles) {
  HAZUMI_ASSERT(static_cast<int>(locked.size()) == num_hinges());
  HAZUMI_ASSERT(angles.size() == num_hinges());
  num_positions_ = num_dofs_ = 0;
  is_quaternion_.clear();
  angles_.clear();
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (num_hinges_of_[i] == 0) continue;
    Node& own = nodes_[i];
    int num_locked = 0;
    for (int h = 0; h < num_hinges_of_[i]; ++h) {
      own.locked[h] = locked[own.first_hinge + h];
      own.angle[h] = angles[own.first_hinge + h];
      if (own.locked[h]) {
        own.sine[h] = std::sin(own.angle[h]);
        own.cosine[h] = std::cos(own.angle[h]);
      }
      num_locked += own.locked[h];
    }
    const bool ball = triple_of_[i] >= 0 && num_locked == 0;
    own.kind = ball ? NodeKind::kBall : NodeKind::kHinges;
    own.position = num_positions_;
    own.dof = num_dofs_;
    own.num_dofs = num_hinges_of_[i] - num_locked;
    own.first_angle = static_cast<int>(angles_.size());
    for (int k = 0; !ball && k < own.num_dofs; ++k) angles_.push_back(num_positions_ + k);
    num_positions_ += ball ? 4 : own.num_dofs;
    num_dofs_ += own.num_dofs;
    is_quaternion_.resize(num_positions_, ball);
  }
}

// q' = q (0, w) / 2 of ball joints.
void RegionLayout::DerivePositions(const double* y, double* dy) const {
  const double* velocities = y + num_positions_;
  for (const Node& own : nodes_) {
    if (own.kind == NodeKind::kHinges) {
      std::copy_n(velocities + own.dof, own.num_dofs, dy + own.position);
    }
    if (own.kind != NodeKind::kBall) continue;
    const double* q = y + own.position;
    const double* w = velocities + own.dof;
    double* qd = dy + own.position;
    qd[0] = 0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]);
    qd[1] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
    qd[2] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
    qd[3] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
  }
}

void RegionLayout::Turn(const VecX& change, double* y) const {
  HAZUMI_ASSERT(change.size() == num_dofs_);
  for (const Node& own : nodes_) {
    double* q = y + own.position;
    const double* turn = change.data() + own.dof;
    if (own.kind == NodeKind::kHinges) {
      for (int k = 0; k < own.num_dofs; ++k) q[k] += turn[k];
    }
    if (own.kind != NodeKind::kBall) continue;
    // q := q (1, turn / 2)
    const std::array<double, 4> from = {q[0], q[1], q[2], q[3]};
    const double x = 0.5 * turn[0], y_half = 0.5 * turn[1], z = 0.5 * turn[2];
    q[0] += -from[1] * x - from[2] * y_half - from[3] * z;
    q[1] += from[0] * x + from[2] * z - from[3] * y_half;
    q[2] += from[0] * y_half + from[3] * x - from[1] * z;
    q[3] += from[0] * z + from[1] * y_half - from[2] * x;
  }
}

void RegionLayout::Pack(const VecX& q, const VecX& qd, double* y) const {
  HAZUMI_ASSERT(q.size() == num_hinges() && qd.size() == num_hinges());
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const Node& own = nodes_[i];
    double* position = y + own.position;
    double* velocity = y + num_positions_ + own.dof;
    if (const HingeTriple* ball = triple(static_cast<int>(i))) {
      const Vec3 angles = q.segment<3>(own.first_hinge);
      const Eigen::Quaterniond turn(ball->Rotation(angles));
      Eigen::Map<Eigen::Vector4d>(position, 4) << turn.w(), turn.x(), turn.y(), turn.z();
      Eigen::Map<Vec3>(velocity, 3) = ball->AxesInBody(angles) * qd.segment<3>(own.first_hinge);
    } else if (own.kind == NodeKind::kHinges) {
      for (int h = 0; h < num_hinges_of_[i]; ++h) {
        if (own.locked[h]) continue;
        *position++ = q[own.first_hinge + h];
        *velocity++ = qd[own.first_hinge + h];
      }
    }
  }
}

void RegionLayout::Unpack(const double* y, const VecX& lower, const VecX& upper, VecX* q,
                          VecX* qd) const {
  HAZUMI_ASSERT(lower.size() == num_hinges() && upper.size() == num_hinges());
  HAZUMI_ASSERT(q->size() == num_hinges() && qd->size() == num_hinges());
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) UnpackNode(i, y, lower, upper, q, qd);
}

void RegionLayout::UnpackNode(int node, const double* y, const VecX& lower, const VecX& upper,
                              VecX* q, VecX* qd) const {
  const Node& own = nodes_[node];
  const double* position = y + own.position;
  const double* velocity = y + num_positions_ + own.dof;
  const int first = own.first_hinge;
  if (const HingeTriple* ball = triple(node)) {
    const Vec3 near = q->segment<3>(first);
    const bool has_limits = (lower.segment<3>(first).array() > -kWithoutLimit ||
                             upper.segment<3>(first).array() < kWithoutLimit)
                                .any();
    const Vec3 angles = ball->Angles(RotationOfQuaternion(position), near, has_limits);
    q->segment<3>(first) = angles;
    qd->segment<3>(first) = ball->Rates(angles, Eigen::Map<const Vec3>(velocity));
    return;
  }
  for (int h = 0; h < num_hinges_of_[node]; ++h) {
    (*q)[first + h] = own.locked[h] ? own.angle[h] : *position++;
    (*qd)[first + h] = own.locked[h] ? 0.0 : *velocity++;
  }
}

void RegionLayout::UnpackAccelerations(const double* x, const VecX& q, const VecX& qd,
                                       VecX* qdd) const {
  HAZUMI_ASSERT(q.size() == num_hinges() && qd.size() == num_hinges());
  qdd->resize(num_hinges());
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const int first = nodes_[i].first_hinge;
    const double* own = x + nodes_[i].dof;
    if (const HingeTriple* ball = triple(static_cast<int>(i))) {
      qdd->segment<3>(first) = ball->Accelerations(q.segment<3>(first), qd.segment<3>(first),
                                                   Eigen::Map<const Vec3>(own));
      continue;
    }
    for (int h = 0; h < num_hinges_of_[i]; ++h) {
      (*qdd)[first + h] = nodes_[i].locked[h] ? 0.0 : *own++;
    }
  }
}

int RegionLayout::HingeOf(int component) const {
  HAZUMI_ASSERT(component >= 0);
  int hinge = 0;
  const bool is_position = component < num_positions_;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const int first = is_position ? nodes_[i].position : num_positions_ + nodes_[i].dof;
    if (num_hinges_of_[i] > 0 && first <= component) hinge = nodes_[i].first_hinge;
  }
  return hinge;
}

void RegionLayout::Distances(const VecX& q, const VecX& other, VecX* distances) const {
  *distances = (q - other).cwiseAbs();
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (triple_of_[i] < 0) continue;
    const HingeTriple& ball = triples_[triple_of_[i]];
    const int first = nodes_[i].first_hinge;
    const Mat3 between =
        ball.Rotation(q.segment<3>(first)).transpose() * ball.Rotation(other.segment<3>(first));
    // The sine is exact for small angles, where the trace is not.
    const Vec3 twice_sine(between(2, 1) - between(1, 2), between(0, 2) - between(2, 0),
                          between(1, 0) - between(0, 1));
    const double angle = std::atan2(twice_sine.norm(), between.trace() - 1.0);
    distances->segment<3>(first).setConstant(angle);
  }
}

}  // namespace hazumi
