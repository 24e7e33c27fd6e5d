#pragma once

#include <vector>

#include "engine/analysis/placed_frames.h"
#include "engine/bake/motion.h"
#include "engine/dynamics/figure_dynamics.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// A figure with what it holds at some frame of a motion, ready for inverse dynamics.
class LoadedFigure {
 public:
  LoadedFigure(const Animation& animation, const MotionFrame& frame);

  // Whether it holds the same there.
  bool IsThatOf(const MotionFrame& frame) const;
  const Figure& figure() const { return figure_; }

  // The torques that a motion needs with the whole figure hung on its root [N m], and what its root
  // then needs, at its origin. `root`: without gravity.
  Wrench Demand(const MotionLimit& at, RootMotion root, const VecX& qdd, double gravity, VecX* tau);

 private:
  std::vector<int> holders_;  // by held object
  Figure figure_;
  FigureDynamics dynamics_;
  FigureScratch scratch_;
};

// Something outside pushes the body beyond `joint` at p with this force, and this moment: what the
// hinges between it and the root need not give [principle of virtual work]. An invalid joint is the
// root.
void RelieveHinges(const Figure& figure, const PlacedFrame& placed, JointIndex joint, const Vec3& p,
                   const Wrench& push, VecX* tau);

}  // namespace hazumi
