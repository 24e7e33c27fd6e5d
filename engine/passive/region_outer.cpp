// What moves beside the hinges of an island: in flight the centre of mass c of the figure, which
// weighs m_all, and balls (m, I) with their centres at x, which turn with w:
//   c'' = g + sum F / m_all,   x'' = g + sum F / m,   w' = sum r x F / I
// In the answer A of rows to each other [region_rows.cpp] balls are a part of G, as no hinge moves
// them: with n and r, from the ball's centre, of two rows, and signs by the ends that it is,
//   G = n n' / m + (r x n) (r' x n') / I

#include "engine/passive/region_dynamics.h"

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

void RegionDynamics::PlaceBalls(const V3& p_root) {
  for (int i = 0; i < static_cast<int>(outer_.balls.size()); ++i) {
    const BodyMotion& ball = outer_.balls[i];
    const int node = model_.NodeOfBall(i);
    NodeMotion& own = kinematics_.motion()[node];
    places_[node] = {V3(ball.X_WB.p), V3(ball.v)};
    own.R = ToSmall(ball.X_WB.R);
    own.p = places_[node].p - p_root;
    own.w = V3(ball.w);
  }
}

// By what is frozen, which is all that they have been asked for.
void RegionDynamics::AccelerateBalls() {
  for (int i = 0; i < static_cast<int>(model_.balls.size()); ++i) {
    const LooseBall& ball = model_.balls[i];
    NodeMotion& own = kinematics_.motion()[model_.NodeOfBall(i)];
    own.a = (-1.0 / ball.mass) * own.f - V3(0.0, 0.0, gravity_);
    own.alpha = (-1.0 / ball.inertia) * own.n;
  }
}

void RegionDynamics::DeriveOuter(const double* y, double* dy) {
  falls_.head<3>() = kinematics_.added_force().eigen() / model_.mass;
  for (int i = 0; i < static_cast<int>(model_.balls.size()); ++i) {
    const NodeMotion& own = kinematics_.motion()[model_.NodeOfBall(i)];
    falls_.segment<6>(3 + 6 * i) << own.a.eigen(), own.alpha.eigen();
  }
  if (has_rows_) falls_ += KickOf(row_forces_);
  falls_[2] -= gravity_;
  outer_layout_.Derive(y + layout_.state_size(), falls_, dy + layout_.state_size());
}

double RegionDynamics::KineticOfBalls() const {
  double kinetic = 0.0;
  for (size_t i = 0; i < model_.balls.size(); ++i) {
    kinetic += model_.balls[i].KineticEnergy(outer_.balls[i]);
  }
  return kinetic;
}

void RegionDynamics::AddEnergyOfBalls(EnergyFlow* flow) const {
  flow->kinetic += KineticOfBalls();
  for (size_t i = 0; i < model_.balls.size(); ++i) {
    flow->potential += model_.balls[i].PotentialEnergy(outer_.balls[i], gravity_);
  }
}

Vec3 RegionDynamics::NetOf(const ConstraintRow& row, const V3& n) const {
  const bool on_a = row.a >= 0 && !model_.is_ball(row.a);
  const bool on_b = row.b >= 0 && !model_.is_ball(row.b);
  if (row.turns || on_a == on_b) return Vec3::Zero();
  return on_a ? n.eigen() : Vec3(-n.eigen());
}

RegionDynamics::AtBall RegionDynamics::OnBall(int ball, const ConstraintRow& row,
                                              const V3& n) const {
  const int node = model_.NodeOfBall(ball);
  AtBall at = AtBall::Zero();
  if (row.a == node) at << n.eigen(), Cross(row.r_a, n).eigen();
  if (row.b == node) at << -n.eigen(), -Cross(row.r_b, n).eigen();
  return at;
}

void RegionDynamics::LetBallsAnswer() {
  const std::vector<ConstraintRow>& rows = rows_.rows();
  Eigen::Matrix<double, 6, Eigen::Dynamic> moves(6, G_.cols()), pushes(6, G_.cols());
  for (int i = 0; i < static_cast<int>(model_.balls.size()); ++i) {
    for (Eigen::Index k = 0; k < G_.cols(); ++k) {
      const ConstraintRow& row = rows[static_cast<size_t>(k)];
      moves.col(k) = OnBall(i, row, row.n);
      pushes.col(k) = OnBall(i, row, row.force());
    }
    pushes.topRows<3>() /= model_.balls[i].mass;
    pushes.bottomRows<3>() /= model_.balls[i].inertia;
    G_.noalias() += moves.transpose().lazyProduct(pushes);
  }
}

VecX RegionDynamics::KickOf(const VecX& impulses) const {
  VecX kick = VecX::Zero(outer_layout_.num_jumps());
  for (Eigen::Index k = 0; k < impulses.size(); ++k) {
    const ConstraintRow& row = rows_.rows()[static_cast<size_t>(k)];
    kick.head<3>() += impulses[k] * NetOf(row, row.force());
    for (int i = 0; i < static_cast<int>(model_.balls.size()); ++i) {
      kick.segment<6>(3 + 6 * i) += impulses[k] * OnBall(i, row, row.force());
    }
  }
  kick.head<3>() /= model_.mass;
  for (int i = 0; i < static_cast<int>(model_.balls.size()); ++i) {
    kick.segment<3>(3 + 6 * i) /= model_.balls[i].mass;
    kick.segment<3>(6 + 6 * i) /= model_.balls[i].inertia;
  }
  return kick;
}

}  // namespace hazumi
