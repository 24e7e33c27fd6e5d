#pragma once

// Internal: the path of a thrown object onto a spot. The equations are in throw_path.cpp.

#include <string>

#include "engine/timeline/animation.h"

namespace hazumi::makers {

struct ThrowPath {
  Vec3 from = Vec3::Zero(), velocity = Vec3::Zero();  // as it is let go, world [m, m/s]
  double seconds = 0.0;                               // to the spot
};

// Returns the rise of the slowest throw onto a spot above where it is let go [m].
double HeightOfSlowestThrow(const Vec3& from, const Vec3& spot, double gravity);
// Returns the throw that rises so high [m], which must be above the spot.
ThrowPath ThrowOver(const Vec3& from, const Vec3& spot, double height, double gravity);
// Returns the time until it comes down through a height, or until it is highest if it does not rise
// so high [s].
double SecondsDown(const ThrowPath& path, double z, double gravity);
// Returns the first object of the scene in the way of a sphere; empty: none. The place where it
// comes down does not count.
std::string InTheWay(const ThrowPath& path, double radius, const Animation& animation);

}  // namespace hazumi::makers
