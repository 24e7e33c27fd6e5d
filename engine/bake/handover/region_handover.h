#pragma once

#include <set>
#include <vector>

#include "engine/bake/bake_context.h"
#include "engine/bake/walk/region_walk.h"

namespace hazumi {

// At the frames where regions begin and end: gives them their joints, and the curves those back.
class RegionHandover {
 public:
  explicit RegionHandover(BakeContext* context) : context_(*context) {}

  // A stretch begins: none has begun, none is active.
  void Reset();
  // Ends those that end at the frame, or begins those that begin there; true if there are any.
  // `walk`: what moved joints up to there.
  bool End(int frame);
  bool Begin(int frame, const RegionWalk& walk);

  // Regions that are active from a frame on; those that began in this stretch.
  std::vector<int> ActiveFrom(int frame) const;
  const std::vector<int>& begun() const { return begun_; }

 private:
  void BeginRoot(int frame);
  void BeginJoint(JointIndex j, int frame, bool handed_over);
  void EndRoot(int frame, const DynamicsRegion& region);
  void EndJoints(int frame, size_t region);
  void ResumeJoint(int frame, size_t region, JointIndex j);
  void WarnOfOvershoot(int frame, size_t region, JointIndex j, double overshoot);

  BakeContext& context_;
  std::set<int> active_;    // begun and not ended
  std::vector<int> begun_;  // in this stretch
};

// Writes a warning if a joint that something let go of, `place`, moves but has no key after it.
void WarnIfItStopsDead(int frame, JointIndex j, const std::string& place, BakeContext* context);

}  // namespace hazumi
