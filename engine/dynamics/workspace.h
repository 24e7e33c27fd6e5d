#pragma once

#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/types.h"

namespace hazumi {

// What is known and found of one body in one evaluation. World axes throughout; points from the
// world origin, except `c`.
struct BodyScratch {
  Mat3 R = Mat3::Identity();  // R_WJ
  Vec3 p = Vec3::Zero();      // joint origin [m]
  Vec3 axis = Vec3::Zero();   // hinge axis, unit
  Vec3 c = Vec3::Zero();      // from the joint origin to the body's CoM [m]
  Vec3 w = Vec3::Zero();      // angular velocity [rad/s]
  Vec3 v = Vec3::Zero();      // velocity of the joint origin [m/s]
  Vec3 alpha = Vec3::Zero();  // angular acceleration [rad/s^2]
  Vec3 a = Vec3::Zero();      // acceleration of the joint origin [m/s^2]
  Vec3 f = Vec3::Zero();      // force that the joint transmits to the body [N]
  Vec3 n = Vec3::Zero();      // moment about the joint origin [N m]
};

// Every scratch array of the dynamics and nothing else. Made once for a figure; an evaluation
// allocates nothing. Debug builds fill it with NaN, so that nothing unset is ever read unnoticed.
struct DynamicsWorkspace {
  explicit DynamicsWorkspace(const Figure& figure);

  // bodies[0] is the root, bodies[j + 1] the body moved by joint j.
  std::vector<BodyScratch> bodies;
  BodyScratch& body(JointIndex j) { return bodies[j.value() + 1]; }
  const BodyScratch& body(JointIndex j) const { return bodies[j.value() + 1]; }

  VecX tau;  // joint torques of the last inverse dynamics [N m], by JointIndex
};

}  // namespace hazumi
