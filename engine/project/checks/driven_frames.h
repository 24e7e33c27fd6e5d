#pragma once

// Internal. Which joint is driven by a region at which frames, who drives it, and which bodies
// regions may move.

#include <optional>
#include <string>
#include <vector>

#include "engine/project/checks/spans.h"
#include "engine/timeline/animation.h"

namespace hazumi {

using JointSet = std::vector<bool>;  // by JointIndex

JointSet JointsOf(const DynamicsRegion& region, const Figure& figure);
JointSet Common(const JointSet& a, const JointSet& b);
std::optional<JointIndex> FirstOf(const JointSet& set);

class DrivenFrames {
 public:
  explicit DrivenFrames(const Animation& animation);

  void Add(const DynamicsRegion& region);
  // Whether one of the regions that were added drives what the region drives, while it does.
  bool Clashes(const DynamicsRegion& region) const;

  const SpanSet& joint(JointIndex j) const { return joints_[j.value()]; }
  const SpanSet& root() const { return root_; }

  // The first region of the animation that drives one of the joints during the span, added or not:
  // for a message, for it takes as long as there are regions.
  struct Driver {
    std::string region, joint;  // quoted
    Span span;
  };
  std::optional<Driver> FindDriver(const JointSet& joints, Span span) const;

 private:
  const Animation& animation_;
  std::vector<SpanSet> joints_, keyed_;
  SpanSet root_;
};

// Whether a region may move a joint's body in some of these frames; no joint: the root's.
bool MayMove(const DynamicsRegion& region, std::optional<GroupIndex> joint, Span span,
             const Animation& animation);

}  // namespace hazumi
