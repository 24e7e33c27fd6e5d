#pragma once

// Left and right of any figure: which joint is the other side's of which, and the plane between.

#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/figure/side_names.h"

namespace hazumi {

// Joints are a pair if they hang on one joint, or on a pair, and
// - their roles, as the figure states them, are the same on the two sides, or
// - one's name is the other's for the other side, or
// - both name a side, and nothing else that hangs there and has no partner does, or
// - they hang on a pair, and nothing else that hangs there has no partner.
class FigureSides {
 public:
  explicit FigureSides(const Figure& figure);

  // Its partner, or itself if it has none.
  GroupIndex OtherSideOf(GroupIndex joint) const { return other_[joint.value()]; }
  // The hinge of its joint's partner that is called as it is but for the joint, or is the same in
  // the row; itself if its joint has none.
  JointIndex OtherSideOf(JointIndex hinge, const Figure& figure) const;
  // Of a joint or a hinge by its name; other names are their own.
  std::string OtherSideOf(const std::string& name, const Figure& figure) const;

  // A joint without a partner is on the side that its role or its name says, or else its parent's.
  BodySide SideOf(GroupIndex joint) const { return side_[joint.value()]; }

  // Of the mirror plane, which goes through the root's origin, in the root's frame: the mean
  // direction from right to left, all angles zero. An axis of that frame if one lies within 10
  // degrees, since hardly any skeleton that was measured is quite the same on both sides. Without
  // pairs: y.
  const Vec3& normal() const { return normal_; }

 private:
  std::vector<GroupIndex> other_;
  std::vector<BodySide> side_;
  Vec3 normal_ = Vec3::UnitY();
};

// The bodies of all joints in the root's frame, all angles zero.
std::vector<Pose> PosesAtZero(const Figure& figure);

}  // namespace hazumi
