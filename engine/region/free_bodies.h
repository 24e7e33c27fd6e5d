#pragma once

#include <vector>

#include "engine/region/constraints/constraint_row.h"
#include "engine/region/node_motion.h"
#include "engine/region/outer_motion.h"

namespace hazumi {

// Responses of everything that moves besides the hinges of an island to forces and impulses on
// rows: in flight the centre of mass of the figure, and balls, rigid bodies of their own.
class FreeBodies {
 public:
  // `model` must outlive this object. `gravity`: along -z [m/s^2].
  FreeBodies(const RegionModel* model, double gravity) : model_(model), gravity_(gravity) {}

  double gravity() const { return gravity_; }

  // Sets the accelerations of balls by the forces on them, before those of rows.
  void Accelerate(NodeKinematics* nodes) const;
  // Accelerations in the order of OuterLayout's jumps. `row_forces`: of `rows`; null: there are no
  // rows.
  VecX Accelerations(const NodeKinematics& nodes, const std::vector<ConstraintRow>& rows,
                     const VecX* row_forces) const;
  // Velocity changes due to impulses on the rows, in the same order [m/s, rad/s].
  VecX VelocityChanges(const std::vector<ConstraintRow>& rows, const VecX& impulses) const;
  // Adds the response of balls to forces on the rows: changes of the rows' accelerations.
  void AddResponse(const std::vector<ConstraintRow>& rows, MatX* response) const;
  // Direction in which a force on the row pushes the figure as a whole; n is along the row.
  Vec3 NetOf(const ConstraintRow& row, const small::V3& n) const;

  // Energy of the balls [J].
  double KineticEnergy(const OuterMotion& motion) const;
  void AddPotentialEnergy(const OuterMotion& motion, double* energy) const;

 private:
  using AtBall = Eigen::Matrix<double, 6, 1>;
  AtBall OnBall(int ball, const ConstraintRow& row, const small::V3& n) const;
  int num_balls() const { return static_cast<int>(model_->balls.size()); }

  const RegionModel* model_;
  double gravity_;
};

}  // namespace hazumi
