#pragma once

// Measures of harm that a motion does to a figure.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi::test {

// Pairs of links of a figure, neither of them neighbours nor in each other at rest.
class OwnBody {
 public:
  explicit OwnBody(const Figure& figure) : figure_(figure) {
    const std::vector<Capsule> rest = At(Pose(), VecX::Zero(figure.num_joints()));
    for (size_t a = 0; a < rest.size(); ++a) {
      for (size_t b = a + 1; b < rest.size(); ++b) {
        if (AreNeighbours(a, b) || SignedDistance(rest[a], rest[b]).value < 0.0) continue;
        pairs_.emplace_back(a, b);
      }
    }
  }

  // Largest depth of a link in another one [m], and which they are.
  double Depth(const MotionFrame& frame, std::string* which) const {
    const std::vector<Capsule> now = At(frame.X_WR, frame.after.q);
    double deepest = 0.0;
    for (const auto& [a, b] : pairs_) {
      const double depth = -SignedDistance(now[a], now[b]).value;
      if (depth <= deepest) continue;
      deepest = depth;
      *which = NameOf(a) + " in " + NameOf(b);
    }
    return deepest;
  }

 private:
  std::string NameOf(size_t link) const {
    const JointIndex j = figure_.links()[link].joint;
    return j.is_valid() ? figure_.group(figure_.joint(j).group).name : "root";
  }
  bool AreNeighbours(size_t a, size_t b) const {
    const auto group = [&](JointIndex j) {
      return j.is_valid() ? figure_.joint(j).group.value() : -1;
    };
    const auto above = [&](JointIndex j) {
      if (!j.is_valid()) return -2;
      const JointIndex first = figure_.group(figure_.joint(j).group).first;
      return group(figure_.joint(first).parent);
    };
    const JointIndex i = figure_.links()[a].joint, j = figure_.links()[b].joint;
    return group(i) == group(j) || above(i) == group(j) || above(j) == group(i);
  }
  std::vector<Capsule> At(const Pose& X_WR, const VecX& q) const {
    DynamicsWorkspace ws(figure_);
    ComputePositions(figure_, X_WR, q, &ws);
    std::vector<Capsule> all;
    for (const Link& link : figure_.links()) {
      const Pose X =
          link.joint.is_valid() ? Pose{ws.body(link.joint).R, ws.body(link.joint).p} : X_WR;
      all.push_back({X * link.capsule.a, X * link.capsule.b, link.capsule.radius});
    }
    return all;
  }

  const Figure& figure_;
  std::vector<std::pair<size_t, size_t>> pairs_;
};

// Largest rates, angles beyond limits and depths in the own body of a motion.
struct Most {
  double rate = 0.0, beyond = 0.0, depth = 0.0;  // [rad/s, rad, m]
  std::string fastest, deepest;
};
inline Most MostOf(const Motion& motion, const Figure& figure) {
  const OwnBody own(figure);
  Most most;
  for (const MotionFrame& frame : motion.frames) {
    for (int j = 0; j < figure.num_joints(); ++j) {
      const Joint& joint = figure.joint(JointIndex(j));
      for (const MotionLimit* at : {&frame.before, &frame.after}) {
        most.beyond = std::max({most.beyond, at->q[j] - joint.upper, joint.lower - at->q[j]});
        if (std::abs(at->qd[j]) <= most.rate) continue;
        most.rate = std::abs(at->qd[j]);
        most.fastest = joint.name;
      }
    }
    std::string which;
    const double depth = own.Depth(frame, &which);
    if (depth <= most.depth) continue;
    most.depth = depth;
    most.deepest = which;
  }
  return most;
}

}  // namespace hazumi::test
