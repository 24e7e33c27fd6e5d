#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/collision/shapes.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/indices.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/rigid_inertia.h"

namespace hazumi {

// One hinge (Arai 2.1: every joint has one degree of freedom). Its frame J has the hinge's axis
// through its origin and turns with the body beyond the hinge.
struct Joint {
  std::string name;
  JointIndex parent;  // invalid: the root body
  GroupIndex group;
  Pose X_PJ;                  // J in the parent's frame at angle zero (Arai 2.1: M_c)
  Vec3 axis = Vec3::UnitZ();  // unit vector, the same in J at any angle
  double lower = 0.0, upper = 0.0, rest = 0.0;  // [rad]
  JointIndex subtree_end;      // joints [this, subtree_end) are this one and everything beyond
  bool parallel_frame = true;  // X_PJ.R is the identity
  bool massless = false;       // the body between two hinges of one group
  std::optional<JointStrength> strength;  // none: not known

  bool is_fixed() const { return lower == upper; }
};

struct JointGroup {
  std::string name;
  JointIndex first;  // nearest the root
  int size = 1;
  std::optional<BodyPlace> body = {};  // as stated
  JointIndex last() const { return JointIndex(first.value() + size - 1); }
};

// A capsule fixed to a body.
struct Link {
  std::string name;
  JointIndex joint;  // invalid: the root body
  Capsule capsule;   // in the frame of the joint
  std::vector<Look> looks;
  std::optional<LinkSurface> surface =
      {};  // in the frame of the joint; none: air flows round the capsule
};

// A tree of hinges with rigid bodies: immutable once built. Joints are numbered depth first, so a
// parent has a smaller index than its children and every subtree is a contiguous range.
class Figure {
 public:
  const std::string& name() const { return name_; }
  const std::string& root_name() const { return root_name_; }
  int num_joints() const { return static_cast<int>(joints_.size()); }
  const std::vector<Joint>& joints() const { return joints_; }
  const Joint& joint(JointIndex j) const { return joints_[j.value()]; }
  const std::vector<JointGroup>& groups() const { return groups_; }
  const JointGroup& group(GroupIndex g) const { return groups_[g.value()]; }
  // The root's first, then joint by joint.
  const std::vector<Link>& links() const { return links_; }

  // The body moved by joint j, in its frame J; of the root, in the root's frame.
  const RigidInertia& body(JointIndex j) const { return bodies_[j.value()]; }
  const RigidInertia& root_body() const { return root_body_; }
  double total_mass() const { return total_mass_; }  // [kg]

  std::optional<JointIndex> FindJoint(std::string_view name) const;
  std::optional<GroupIndex> FindGroup(std::string_view name) const;
  // True if `ancestor` is `j` or lies between the root and `j`.
  bool IsBeyond(JointIndex j, JointIndex ancestor) const;
  // All joints at their rest angles [rad].
  VecX RestAngles() const;

  // The same figure with `extra` (in the frame of joint j) fixed to the body of j.
  Figure WithLoad(JointIndex j, const RigidInertia& extra) const;

 private:
  friend class FigureAssembler;
  struct NameIndex {
    std::map<std::string, JointIndex, std::less<>> joints;
    std::map<std::string, GroupIndex, std::less<>> groups;
  };
  std::string name_, root_name_;
  std::vector<Joint> joints_;
  std::vector<JointGroup> groups_;
  std::vector<Link> links_;
  std::vector<RigidInertia> bodies_;
  RigidInertia root_body_;
  double total_mass_ = 0.0;
  std::shared_ptr<const NameIndex> index_;  // copies of a figure share it
};

// The joints that sit on a body; an invalid one is the root's.
std::vector<GroupIndex> ChildrenOf(JointIndex body, const Figure& figure);

// The joints that move a joint, from it towards the root: `count` of them, 0 all. Not given: its
// limb, which ends before a joint that carries others too (the chest, of an arm).
std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure);

}  // namespace hazumi
