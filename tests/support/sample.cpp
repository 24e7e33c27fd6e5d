#include "tests/support/sample.h"

namespace hazumi::test {

namespace {

// A root that stands still somewhere, turned.
MovingRoot StillRoot(Random* random) {
  MovingRoot root;
  root.p = random->Vector3(1.0);
  root.angle = random->Vector3(3.0);
  return root;
}

MujocoFigure InMujoco(const Sample& sample) {
  if (sample.root_kind == Root::kMoving) return MujocoFigure(sample.figure, sample.gravity);
  return MujocoFigure(sample.figure, sample.moving_root.X_WR(), sample.gravity);
}

}  // namespace

Sample::Sample(uint64_t sample_seed, Root kind, std::optional<Vec3> given_gravity)
    : seed(sample_seed),
      random(sample_seed),
      figure(sample_seed == 0 ? Human37() : Build(RandomTreeSpec(&random))),
      root_kind(kind),
      moving_root(kind == Root::kMoving ? RandomMovingRoot(&random) : StillRoot(&random)),
      gravity(given_gravity.value_or(random.Vector3(10.0))),
      q(RandomAngles(figure, &random)),
      qd(random.Vector(figure.num_joints(), 5.0)),
      qdd(random.Vector(figure.num_joints(), 50.0)),
      tau(random.Vector(figure.num_joints(), 50.0)),
      ends(RandomEndForces(figure, &random)),
      mujoco(InMujoco(*this)) {
  const bool moves = kind == Root::kMoving;
  mujoco.SetState(moves ? MujocoFigure::Join(moving_root.p, moving_root.angle, q) : q,
                  moves ? MujocoFigure::Join(moving_root.v, moving_root.rate, qd) : qd);
}

DynamicsWorkspace Sample::Placed() const {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, moving_root.X_WR(), q, &ws);
  return ws;
}

RootMotion Sample::RootLessGravity() const {
  RootMotion root = moving_root.Motion();
  root.a -= gravity;
  return root;
}

VecX Sample::Join(const VecX& joint_accelerations) const {
  if (root_kind == Root::kStill) return joint_accelerations;
  return MujocoFigure::Join(moving_root.a, moving_root.acceleration, joint_accelerations);
}

}  // namespace hazumi::test
