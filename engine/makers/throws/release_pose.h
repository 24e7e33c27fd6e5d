#pragma once

// Internal. Pose and speeds of an arm as it lets go of an object that comes down on a spot.

#include <optional>
#include <vector>

#include "engine/makers/throws/throw_path.h"
#include "engine/spatial/pose.h"

namespace hazumi::makers {

// Hinges in a row, each in the frame of the one before.
struct ReleaseHinge {
  Pose X_PJ;                             // its frame at angle 0
  Vec3 axis;                             // in its own frame
  double lower = 0.0, upper = 0.0;       // [rad]
  double wanted = 0.0;                   // the pose is to be near this angle [rad]
  double ease = 1.0;                     // rate that counts as 1 [rad/s]
  double fastest = 17.5;                 // largest rate [rad/s]
  double start = 0.0, start_rate = 0.0;  // with which the arm begins to swing [rad, rad/s]
  bool moves = true;                     // false: it stays at `wanted`
};

// Motion of what carries the arm, as it lets go.
struct ReleaseCarrier {
  Pose pose;
  Vec3 w = Vec3::Zero(), v = Vec3::Zero();  // of its origin, world [rad/s, m/s]
};

struct ReleaseTarget {
  Vec3 offset = Vec3::Zero();    // of the object's centre, in the frame of the last hinge [m]
  Vec3 spot = Vec3::Zero();      // of its centre as it is down, world [m]
  std::optional<double> height;  // rise above where it is let go [m]; nothing: the least speed
  double gravity = 9.81;         // [m/s^2]
  double seconds = 0.3;          // from the start
  double firmness = 1.0;         // how many times as much the pose that is wanted counts as usual
};

struct Release {
  VecX angles, rates;  // [rad, rad/s]
  ThrowPath path;
  double miss = 0.0;  // of the spot [m]
};

Release ReleaseFor(const ReleaseCarrier& carrier, const std::vector<ReleaseHinge>& hinges,
                   const ReleaseTarget& target);

// Distance, as a vector, of a path from a spot [m]. With a height: the error of the velocity times
// the time of flight. Without one: in the plane of the spot, where the path comes down through it.
// Its z has, besides, what the path lacks of rising 5 cm above the spot, or with a height to it.
Vec3 MissOfSpot(const ThrowPath& path, const Vec3& spot, const std::optional<double>& height,
                double gravity);

}  // namespace hazumi::makers
