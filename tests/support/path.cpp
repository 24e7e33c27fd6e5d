#include "tests/support/path.h"

#include "tests/support/figures.h"

namespace hazumi::test {

namespace {

Figure RandomFigure(uint64_t seed) {
  Random random(seed);
  return Build(RandomTreeSpec(&random));
}

MovingRoot RootAt(const MovingRoot& start, double t) {
  MovingRoot root = start;
  root.p += t * start.v + 0.5 * t * t * start.a;
  root.v += t * start.a;
  root.angle += t * start.rate + 0.5 * t * t * start.acceleration;
  root.rate += t * start.acceleration;
  return root;
}

}  // namespace

// Slow enough that the tip of a chain of 40 turns well under a radian in a step of `Derivative`.
Path::Path(uint64_t seed) : figure_(RandomFigure(seed)) {
  Random random(~seed);
  const int n = figure_.num_joints();
  q_ = RandomAngles(figure_, &random);
  qd_ = random.Vector(n, 0.5);
  qdd_ = random.Vector(n, 2.0);
  root_ = RandomMovingRoot(&random);
  root_.rate *= 0.2;
  root_.acceleration *= 0.1;
}

DynamicsWorkspace Path::At(double t) const {
  DynamicsWorkspace ws(figure_);
  const MovingRoot root = RootAt(root_, t);
  ComputePositions(figure_, root.X_WR(), q_ + t * qd_ + 0.5 * t * t * qdd_, &ws);
  ComputeMotion(figure_, root.Motion(), qd_ + t * qdd_, qdd_, &ws);
  return ws;
}

DynamicsWorkspace Path::WithAngleTurned(int joint, double angle) const {
  DynamicsWorkspace ws(figure_);
  VecX q = q_;
  q[joint] += angle;
  ComputePositions(figure_, root_.X_WR(), q, &ws);
  return ws;
}

}  // namespace hazumi::test
