#pragma once

#include <tuple>
#include <vector>

#include "engine/collision/shapes.h"
#include "engine/timeline/solver_rules.h"

namespace hazumi {

// A capsule of the figure, or a ball beside it, as its node's frame sees it [m].
struct ContactCapsule {
  int node = 0;
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double radius = 0.0;
  int link = -1;             // of the figure, for those who are told
  double restitution = 0.0;  // Poisson's: of an impulse, so much again as it bounces; 0 to 1
  bool meets_obstacles = true;
  int ball = -1;          // held object, for those who are told; -1: it is part of the figure
  double friction = 1.0;  // times that of an obstacle is the coefficient
};
inline auto MembersOf(const ContactCapsule& capsule) {
  const auto& [node, a, b, radius, link, restitution, meets_obstacles, ball, friction] = capsule;
  return std::tie(node, a, b, radius, link, restitution, meets_obstacles, ball, friction);
}

// Something that does not give way: a plane, or a box. World axes [m].
struct ContactObstacle {
  bool is_box = false;
  Vec3 normal = Vec3::UnitZ();  // of a plane, whose points x have normal . x = offset
  double offset = 0.0;
  Vec3 p = Vec3::Zero();  // of a box: its centre, its axes, half its edges
  Mat3 R = Mat3::Identity();
  Vec3 half_size = Vec3::Zero();
  double friction = 0.0;  // coefficient between it and links of the figure
  int object = -1;        // of the scene, for those who are told
};
inline auto MembersOf(const ContactObstacle& obstacle) {
  const auto& [is_box, normal, offset, p, R, half_size, friction, object] = obstacle;
  return std::tie(is_box, normal, offset, p, R, half_size, friction, object);
}

// Two capsules, by their indices, that stay out of each other.
struct OwnContact {
  int a = 0, b = 0;
  double friction = 0.0;  // coefficient between them
};
inline auto MembersOf(const OwnContact& own) {
  const auto& [a, b, friction] = own;
  return std::tie(a, b, friction);
}

// Capsule and obstacle, by index, that do not collide.
struct ContactExemption {
  int capsule = 0, obstacle = 0;
};
inline auto MembersOf(const ContactExemption& exemption) {
  const auto& [capsule, obstacle] = exemption;
  return std::tie(capsule, obstacle);
}

// What may touch what, as plain values that caches compare.
struct ContactSpec {
  std::vector<ContactCapsule> capsules;
  std::vector<ContactObstacle> obstacles;
  std::vector<OwnContact> own = {};
  std::vector<ContactExemption> exempt = {};
  SolverRules rules{kSolverVersion};
  bool empty() const { return capsules.empty() || (obstacles.empty() && own.empty()); }
};
inline auto MembersOf(const ContactSpec& spec) {
  const auto& [capsules, obstacles, own, exempt, rules] = spec;
  return std::tie(capsules, obstacles, own, exempt, rules);
}

}  // namespace hazumi
