#pragma once

// Internal: the path of what is thrown onto a spot. The equations are in throw_path.cpp.

#include <string>

#include "engine/timeline/animation.h"

namespace hazumi::edit {

struct ThrowPath {
  Vec3 from = Vec3::Zero(), velocity = Vec3::Zero();  // as it is let go, world [m, m/s]
  double seconds = 0.0;                               // to the spot
};

// How high above where it is let go the slowest throw onto a spot rises [m].
double HeightOfSlowestThrow(const Vec3& from, const Vec3& spot, double gravity);
// The velocity of a throw that rises so high, and its time. It must rise above the spot.
ThrowPath ThrowOver(const Vec3& from, const Vec3& spot, double height, double gravity);
// Until it comes down through a height, or, if it does not rise so high, until it is highest [s].
double SecondsDown(const ThrowPath& path, double z, double gravity);
// The first thing of the scene that is in the way of a sphere; empty: nothing. Where it comes down
// does not count.
std::string InTheWay(const ThrowPath& path, double radius, const Animation& animation);

}  // namespace hazumi::edit
