#pragma once

// Figures that fall onto things, for tests of contacts. Metres, kilograms.

#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/force_cases.h"

namespace hazumi::test {

inline constexpr double kBallRadius = 0.1;

// Let go at the first frame, and placed by what it touches.
inline Animation Loose(Figure figure, int frames, const std::vector<const char*>& joints = {}) {
  Animation animation = Exact(std::move(figure), kG);
  animation.last_frame = frames;
  AddGravity(&animation, 0, frames);
  FreeAll(&animation, joints);
  animation.regions[0].last_frame = frames;
  animation.regions[0].touches_scene = true;
  return animation;
}

inline void SetRootAt(Animation* animation, const Vec3& p) {
  for (int i = 0; i < 3; ++i) animation->root_keys[i] = {{0, p[i], 0.0, kHold}};
}

// A plane through the origin that falls towards +x, with the coefficient that it has with a figure.
inline Vec3 AddIncline(Animation* animation, double angle, double friction) {
  SceneObject slope;
  slope.name = "slope";
  slope.shape = Plane{Vec3(std::sin(angle), 0.0, std::cos(angle)), 0.0};
  slope.friction = friction * friction / SceneObject::kFriction;
  animation->scene.push_back(slope);
  return Vec3(std::cos(angle), 0.0, -std::sin(angle));
}

inline double ClearanceOf(const Animation& animation, const MotionFrame& frame) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  return Clearance(*animation.figure, animation.scene, ws);
}

inline double EnergyOf(const Animation& animation, const MotionLimit& at) {
  const Momentum momentum = MomentumOf(*animation.figure, at);
  return momentum.kinetic + momentum.potential(animation.gravity);
}

}  // namespace hazumi::test
