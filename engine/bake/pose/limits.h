#pragma once

#include "engine/bake/motion.h"
#include "engine/placement/figure_motion.h"
#include "engine/spatial/jet.h"

namespace hazumi {

inline MotionLimit LimitOf(const FigureMotion& motion) {
  return {motion.q, motion.qd, motion.X_WR, motion.root.w, motion.root.v};
}

// The root's pose as a function of time: its orientation from the angles' curves, its position from
// the velocity and acceleration of `motion`.
inline PoseOf<Jet> RootJet(const RootAngles& angles, const FigureMotion& motion) {
  const Vec3 axes[3] = {Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()};
  PoseOf<Jet> X;
  for (int i = 0; i < 3; ++i) {
    const Jet angle(angles.angle[i], angles.rate[i], angles.acceleration[i]);
    Turn<Jet>(axes[i], sin(angle), cos(angle), &X.R);
    X.p[i] = Jet(motion.X_WR.p[i], motion.root.v[i], motion.root.a[i]);
  }
  return X;
}

}  // namespace hazumi
