#pragma once

#include <tuple>
#include <vector>

#include "engine/spatial/body_motion.h"

namespace hazumi {

// What no hinge tells of an island: where the figure is, and the balls that its contacts may meet.
struct OuterMotion {
  // Of the pin or, in flight, of the centre of mass.
  PointMotion anchor;
  std::vector<BodyMotion> balls;  // as RegionModel::balls

  // By jumps of velocities: the anchor's, then of each ball those of v and w.
  void Jump(const VecX& by);
};
inline auto MembersOf(const OuterMotion& motion) {
  const auto& [anchor, balls] = motion;
  return std::tie(anchor, balls);
}

// How it makes up the end of a state: the anchor's position and velocity, where the fall is solved
// along; of each ball position, quaternion (w, x, y, z), velocity and angular velocity.
class OuterLayout {
 public:
  OuterLayout(bool has_anchor, int num_balls) : has_anchor_(has_anchor), num_balls_(num_balls) {}

  int size() const { return (has_anchor_ ? kAnchor : 0) + kBall * num_balls_; }
  int num_jumps() const { return 3 + 6 * num_balls_; }
  void Pack(const OuterMotion& motion, double* y) const;
  // What is no part of it is left.
  void Unpack(const double* y, OuterMotion* motion) const;
  // Moves it on by small ways, in the order of jumps.
  void MoveOn(const VecX& by, double* y) const;
  // Changes its velocities.
  void Jump(const VecX& by, double* y) const;
  // dy/dt of y, with these accelerations, in the order of jumps.
  void Derive(const double* y, const VecX& accelerations, double* dy) const;

  enum class Part { kPlace, kQuaternion, kRate };
  Part PartAt(int component) const;

 private:
  static constexpr int kAnchor = 6, kBall = 13;
  static constexpr int kTurn = 3, kRates = 7;  // of a ball's
  int FirstOf(int ball) const { return (has_anchor_ ? kAnchor : 0) + kBall * ball; }

  bool has_anchor_;
  int num_balls_;
};

}  // namespace hazumi
