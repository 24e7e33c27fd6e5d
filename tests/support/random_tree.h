#pragma once

// Random figures and states for tests against an oracle.

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/figure/figure.h"
#include "engine/figure/figure_spec.h"
#include "tests/support/random.h"

namespace hazumi::test {

// A tree of 3 to 40 hinges in groups of one to three (the inner hinges of a group massless), with
// random parents, offsets, joint-frame orientations, axes (orthogonal within a group, so that only
// the middle hinge can line up the others) and physical inertias.
FigureSpec RandomTreeSpec(Random* random);

// Angles with every middle hinge at least 0.5 rad from the pose that lines up its neighbours.
VecX RandomAngles(const Figure& figure, Random* random);

EndForces RandomEndForces(const Figure& figure, Random* random);

// A root that moves along a curve: translation, and angles about x, y, z in this order from the
// world inwards, each with its first two derivatives.
struct MovingRoot {
  Vec3 p = Vec3::Zero(), v = Vec3::Zero(), a = Vec3::Zero();                    // [m, m/s, m/s^2]
  Vec3 angle = Vec3::Zero(), rate = Vec3::Zero(), acceleration = Vec3::Zero();  // [rad ...]

  Pose X_WR() const;
  RootMotion Motion() const;
};

MovingRoot RandomMovingRoot(Random* random);

}  // namespace hazumi::test
