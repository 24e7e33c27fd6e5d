#pragma once

// Body that a figure is: its joints by role, and its hinges by what they do.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/figure/body_role.h"
#include "engine/figure/figure.h"

namespace hazumi {

// A hinge, and how much of an angle of the human that comes with Hazumi it does.
struct HingeShare {
  JointIndex hinge;
  double share = 1.0;
};

// Roles are those that the figure states or, if it states none, those that its joints' names tell.
// A hinge does what its name says after its joint's: "LeftArm_flexion" is the flexion of an upper
// arm. Several joints in a row, as of a spine, share what the human has: with k joints in a row the
// i-th covers the part from i/k to (i+1)/k of the human's row.
class FigureBody {
 public:
  explicit FigureBody(const Figure& figure);

  BodyPlace PlaceOf(GroupIndex joint) const { return places_[joint.value()]; }
  // The joint of that role nearest to the root.
  std::optional<GroupIndex> Find(BodyRole role, BodySide side) const;
  // From the root out.
  std::vector<GroupIndex> All(BodyRole role, BodySide side) const;

  // Whether its trunk, from the hips to where the arms begin, lies rather than stands, all angles
  // zero: its arms are front legs.
  bool HasFourLegs() const;

  // The hinges that do what a hinge of the human does, such as "r_hip_flexion" or "knee"; fixed
  // ones do nothing. Empty: none.
  std::vector<HingeShare> HingesFor(const std::string& human_hinge) const;
  // The same of a hinge that is not shared.
  std::optional<JointIndex> HingeFor(const std::string& human_hinge) const;

  // The angles that the human would have in this pose, by name of its hinges, in the unit of `q`;
  // those of which the figure has none are left out.
  std::vector<std::pair<std::string, double>> HumanAngles(const VecX& q) const;

 private:
  std::vector<GroupIndex> Row(BodyRole role, BodySide side) const;
  std::optional<JointIndex> HingeNamed(GroupIndex joint, const std::string& motion) const;

  const Figure& figure_;
  std::vector<BodyPlace> places_;  // by joint
};

// Height of the root's origin above the lowest point of a figure whose angles are all zero [m]: of
// a body that stands upright.
double StandingHeight(const Figure& figure);

}  // namespace hazumi
