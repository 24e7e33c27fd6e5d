#pragma once

#include <optional>
#include <vector>

#include "engine/bake/bake_context.h"
#include "engine/bake/walk/region_walk.h"

namespace hazumi {

// What jumps at a frame where regions, placements or holds begin or end, if BakeOptions::seams asks
// for it: hinge by hinge and of the root, the limit from the right less the one from the left.
class SeamFinder {
 public:
  explicit SeamFinder(BakeContext* context) : context_(*context) {}

  // At a frame, before anything ends or begins there. `walk` led there.
  void Open(int frame, RegionWalk* walk);
  // After that: `now` is the limit from the right.
  void Cross();
  // With these rates of the joints and accelerations it goes on from there.
  void Close(const VecX& rates, const MotionAcceleration& after);
  bool is_open() const { return is_open_; }

 private:
  struct Border {
    SeamOf of;
    int index;
    bool begins;
    std::vector<JointIndex> joints;  // besides the root
  };
  void FindBorders(int frame);
  void AddHinges(const Border& border, const MotionAcceleration& after);
  void AddRoot(const Border& border, const MotionAcceleration& after);
  SeamMend MendOf(const Border& border, JointIndex j, double jump);

  BakeContext& context_;
  bool is_open_ = false;
  int frame_ = 0;
  std::vector<Border> borders_;
  std::vector<char> is_told_;  // by JointIndex: at this frame, by an earlier border
  MotionLimit before_, after_;
  MotionAcceleration left_;
};

}  // namespace hazumi
