#pragma once

// Questions about the dynamics of a whole figure, and the answers of slower routes.

#include <string>
#include <vector>

#include "engine/dynamics/figure_dynamics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

// A figure in a random state on a moving root.
struct Case {
  Case(const Figure& of, uint64_t seed)
      : figure(of), random(seed), moving_root(RandomMovingRoot(&random)), n(of.num_joints()) {
    q = RandomAngles(figure, &random);
    qd = random.Vector(n, 5.0);
    qdd = random.Vector(n, 50.0);
    tau = random.Vector(n, 50.0);
    ends = RandomEndForces(figure, &random);
  }

  VecX Torques(const FigureDynamics& dynamics, FigureScratch* scratch) const {
    VecX result(n);
    dynamics.InverseDynamics(moving_root.X_WR(), moving_root.Motion(), q, qd, qdd, &ends, scratch,
                             &result);
    return result;
  }

  // The same by the recursion in world axes.
  DynamicsWorkspace Placed() const {
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, moving_root.X_WR(), q, &ws);
    return ws;
  }
  VecX TorquesInWorldAxes(const VecX& at_qdd) const {
    DynamicsWorkspace ws = Placed();
    hazumi::InverseDynamics(figure, moving_root.Motion(), qd, at_qdd, &ends, &ws);
    return ws.tau;
  }

  const Figure figure;
  Random random;
  MovingRoot moving_root;
  int n;
  VecX q, qd, qdd, tau;
  EndForces ends;
};

// A joint with hinges about these axes, somewhere on its parent, and a link on it.
inline JointSpec Joint(const std::string& name, const std::string& parent,
                       const std::vector<Vec3>& axes, Random* random) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = random->Vector3(0.3);
  for (size_t h = 0; h < axes.size(); ++h) {
    joint.hinges.push_back({std::string(1, static_cast<char>('a' + h)), axes[h], -3.0, 3.0});
  }
  LinkSpec link;
  link.to = Vec3(0.1, 0.2, -0.3) + random->Vector3(0.1);
  link.radius = 0.05;
  link.mass = 1.0 + random->Uniform(0.0, 1.0);
  joint.links = {link};
  return joint;
}

inline FigureSpec EmptySpec() {
  FigureSpec spec;
  spec.name = "test";
  spec.root_name = "root";
  return spec;
}

}  // namespace hazumi::test
