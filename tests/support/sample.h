#pragma once

// One random question of dynamics: a figure, a state, what acts on it, and the same in MuJoCo.

#include <optional>

#include "engine/dynamics/kinematics.h"
#include "engine/dynamics/workspace.h"
#include "tests/support/figures.h"
#include "tests/support/mujoco_figure.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

enum class Root { kStill, kMoving };

struct Sample {
  // The human for seed 0, a random tree for any other. Gravity is random unless it is given.
  Sample(uint64_t seed, Root root_kind, std::optional<Vec3> gravity = std::nullopt);

  // Positions computed; InverseDynamics may follow.
  DynamicsWorkspace Placed() const;
  // `root` with the acceleration of gravity taken off, as the dynamics wants it.
  RootMotion RootLessGravity() const;
  // MuJoCo's rows of the figure's joints.
  VecX JointRows(const VecX& all) const { return all.tail(figure.num_joints()); }
  // Root and joint accelerations in MuJoCo's order.
  VecX Join(const VecX& joint_accelerations) const;

  uint64_t seed;
  Random random;
  Figure figure;
  Root root_kind;
  MovingRoot moving_root;
  Vec3 gravity;
  VecX q, qd, qdd, tau;
  EndForces ends;
  MujocoFigure mujoco;  // at this state
};

constexpr uint64_t kSamples = 201;

}  // namespace hazumi::test
