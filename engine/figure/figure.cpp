#include "engine/figure/figure.h"

namespace hazumi {

namespace {

template <typename Names>
std::optional<typename Names::mapped_type> Find(const Names& names, std::string_view name) {
  const auto it = names.find(name);
  if (it == names.end()) return std::nullopt;
  return it->second;
}

}  // namespace

std::optional<JointIndex> Figure::FindJoint(std::string_view name) const {
  if (!index_) return std::nullopt;
  return Find(index_->joints, name);
}

std::optional<GroupIndex> Figure::FindGroup(std::string_view name) const {
  if (!index_) return std::nullopt;
  return Find(index_->groups, name);
}

bool Figure::IsBeyond(JointIndex j, JointIndex ancestor) const {
  return ancestor <= j && j < joint(ancestor).subtree_end;
}

VecX Figure::RestAngles() const {
  VecX q(num_joints());
  for (int j = 0; j < num_joints(); ++j) q[j] = joints_[j].rest;
  return q;
}

Figure Figure::WithLoad(JointIndex j, const RigidInertia& extra) const {
  Figure loaded = *this;
  loaded.bodies_[j.value()] = Combine(body(j), extra);
  loaded.joints_[j.value()].massless = loaded.bodies_[j.value()].is_massless();
  loaded.total_mass_ += extra.mass;
  return loaded;
}

std::vector<GroupIndex> ChildrenOf(JointIndex body, const Figure& figure) {
  std::vector<GroupIndex> children;
  for (int g = 0; g < static_cast<int>(figure.groups().size()); ++g) {
    if (figure.joint(figure.groups()[g].first).parent == body) children.emplace_back(g);
  }
  return children;
}

std::vector<GroupIndex> ChainOf(GroupIndex moved, std::optional<int> count, const Figure& figure) {
  std::vector<GroupIndex> joints;
  for (JointIndex j = figure.joint(figure.group(moved).first).parent; j.is_valid();) {
    const GroupIndex group = figure.joint(j).group;
    if (count && *count > 0 && static_cast<int>(joints.size()) == *count) break;
    if (!count && !joints.empty() && ChildrenOf(figure.group(group).last(), figure).size() > 1)
      break;
    joints.push_back(group);
    j = figure.joint(figure.group(group).first).parent;
  }
  return joints;
}

}  // namespace hazumi
