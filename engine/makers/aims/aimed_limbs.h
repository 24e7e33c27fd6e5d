#pragma once

// Internal. The limbs of a region that is aimed, with the numbers of all their torques: limb by
// limb, as AimedLimb::torques.

#include <memory>
#include <vector>

#include "engine/makers/aims/aimed_limb.h"

namespace hazumi::makers {

class AimedLimbs {
 public:
  explicit AimedLimbs(const Figure& figure) : figure_(figure) {}

  void Add(std::unique_ptr<AimedLimb> limb) { limbs_.push_back(std::move(limb)); }
  auto begin() const { return limbs_.begin(); }
  auto end() const { return limbs_.end(); }

  // Solves all limbs; returns their torques [N m].
  VecX Solve(const LimbWay& way);
  int iterations() const;  // of the last Solve
  // Torques that count as 1 [N m].
  VecX Strengths() const;
  // Derivatives of the angles or rates of all hinges of the figure by all torques, in a frame:
  // limbs do not feel each other [rad / N m, rad/s / N m].
  MatX ChangeOf(int frame, bool is_rate) const;
  // Numbers of the torques at the last few keys up to a frame, behind another one, of each hinge of
  // the limbs that have a goal there or later.
  std::vector<int> TorquesBefore(int frame, int behind, int keys) const;
  // Largest depth of the limbs in planes and boxes in a motion, up to their last goals [m].
  double DepthIn(const Motion& motion) const;

 private:
  const Figure& figure_;
  std::vector<std::unique_ptr<AimedLimb>> limbs_;
};

}  // namespace hazumi::makers
