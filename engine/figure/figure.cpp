#include "engine/figure/figure.h"

namespace hazumi {

namespace {

template <typename Index, typename Items>
std::optional<Index> FindByName(const Items& items, std::string_view name) {
  for (size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return Index(static_cast<int>(i));
  }
  return std::nullopt;
}

}  // namespace

std::optional<JointIndex> Figure::FindJoint(std::string_view name) const {
  return FindByName<JointIndex>(joints_, name);
}

std::optional<GroupIndex> Figure::FindGroup(std::string_view name) const {
  return FindByName<GroupIndex>(groups_, name);
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

}  // namespace hazumi
