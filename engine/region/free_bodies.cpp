// In flight the centre of mass c of the figure of mass m_all, and balls (m, I) with centres at x
// and angular velocities w:
//   c'' = g + sum F / m_all,   x'' = g + sum F / m,   w' = sum r x F / I
// The response A of rows to forces on each other [row_system.cpp] has balls as a part of G, since
// no hinge moves them. With n and r, from the ball's centre, of two rows, and signs by the ends:
//   G = n n' / m + (r x n) (r' x n') / I

#include "engine/region/free_bodies.h"

#include "engine/spatial/checks.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

void FreeBodies::Accelerate(NodeKinematics* nodes) const {
  HAZUMI_ASSERT(num_balls() == 0 || nodes->is_ball(model_->NodeOfBall(0)));
  for (int i = 0; i < num_balls(); ++i) {
    const LooseBall& ball = model_->balls[i];
    NodeMotion& own = nodes->motion()[model_->NodeOfBall(i)];
    own.a = (-1.0 / ball.mass) * own.f - V3(0.0, 0.0, gravity_);
    own.alpha = (-1.0 / ball.inertia) * own.n;
  }
}

VecX FreeBodies::Accelerations(const NodeKinematics& nodes, const std::vector<ConstraintRow>& rows,
                               const VecX* row_forces) const {
  VecX accelerations(3 + 6 * num_balls());
  accelerations.head<3>() = nodes.added_force().eigen() / model_->mass;
  for (int i = 0; i < num_balls(); ++i) {
    const NodeMotion& own = nodes.motion()[model_->NodeOfBall(i)];
    accelerations.segment<6>(3 + 6 * i) << own.a.eigen(), own.alpha.eigen();
  }
  if (row_forces != nullptr) accelerations += VelocityChanges(rows, *row_forces);
  accelerations[2] -= gravity_;
  return accelerations;
}

double FreeBodies::KineticEnergy(const OuterMotion& motion) const {
  HAZUMI_ASSERT(motion.balls.size() == model_->balls.size());
  double kinetic = 0.0;
  for (size_t i = 0; i < model_->balls.size(); ++i) {
    kinetic += model_->balls[i].KineticEnergy(motion.balls[i]);
  }
  return kinetic;
}

void FreeBodies::AddPotentialEnergy(const OuterMotion& motion, double* energy) const {
  HAZUMI_ASSERT(motion.balls.size() == model_->balls.size());
  for (size_t i = 0; i < model_->balls.size(); ++i) {
    *energy += model_->balls[i].PotentialEnergy(motion.balls[i], gravity_);
  }
}

Vec3 FreeBodies::NetOf(const ConstraintRow& row, const V3& n) const {
  const bool on_a = row.a >= 0 && !model_->is_ball(row.a);
  const bool on_b = row.b >= 0 && !model_->is_ball(row.b);
  if (row.turns || on_a == on_b) return Vec3::Zero();
  return on_a ? n.eigen() : Vec3(-n.eigen());
}

// How a force along n of a row, or a motion, acts on a ball: along n, and about the centre.
FreeBodies::AtBall FreeBodies::OnBall(int ball, const ConstraintRow& row, const V3& n) const {
  const int node = model_->NodeOfBall(ball);
  AtBall at = AtBall::Zero();
  if (row.a == node) at << n.eigen(), Cross(row.r_a, n).eigen();
  if (row.b == node) at << -n.eigen(), -Cross(row.r_b, n).eigen();
  return at;
}

void FreeBodies::AddResponse(const std::vector<ConstraintRow>& rows, MatX* response) const {
  HAZUMI_ASSERT(response->rows() == response->cols());
  HAZUMI_ASSERT(response->cols() == static_cast<Eigen::Index>(rows.size()));
  const Eigen::Index count = response->cols();
  if (count == 0) return;
  Eigen::Matrix<double, 6, Eigen::Dynamic> moves(6, count), pushes(6, count);
  for (int i = 0; i < num_balls(); ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const ConstraintRow& row = rows[static_cast<size_t>(k)];
      moves.col(k) = OnBall(i, row, row.n);
      pushes.col(k) = OnBall(i, row, row.force());
    }
    pushes.topRows<3>() /= model_->balls[i].mass;
    pushes.bottomRows<3>() /= model_->balls[i].inertia;
    response->noalias() += moves.transpose().lazyProduct(pushes);
  }
}

VecX FreeBodies::VelocityChanges(const std::vector<ConstraintRow>& rows,
                                 const VecX& impulses) const {
  HAZUMI_ASSERT(impulses.size() <= static_cast<Eigen::Index>(rows.size()));
  VecX changes = VecX::Zero(3 + 6 * num_balls());
  for (Eigen::Index k = 0; k < impulses.size(); ++k) {
    const ConstraintRow& row = rows[static_cast<size_t>(k)];
    changes.head<3>() += impulses[k] * NetOf(row, row.force());
    for (int i = 0; i < num_balls(); ++i) {
      changes.segment<6>(3 + 6 * i) += impulses[k] * OnBall(i, row, row.force());
    }
  }
  changes.head<3>() /= model_->mass;
  for (int i = 0; i < num_balls(); ++i) {
    changes.segment<3>(3 + 6 * i) /= model_->balls[i].mass;
    changes.segment<3>(6 + 6 * i) /= model_->balls[i].inertia;
  }
  return changes;
}

}  // namespace hazumi
