#pragma once

#include <cstdint>
#include <random>

#include "engine/collision/shapes.h"

namespace hazumi::test {

enum class ObstacleKind { kPlane, kBox, kCapsule };

// A capsule, an obstacle near it and a path. Sizes 1 mm to 100 m, log-uniform.
struct Scene {
  Capsule capsule;
  Obstacle obstacle;
  Vec3 translation;
};

// The index chooses one of the families (general; axis-aligned on a grid; sphere; parallel; nearly
// parallel, 1e-13 to 1e-3 rad; through the centre; no radius; a limb at a large obstacle) and one
// of the paths (towards the obstacle, far beyond it, along an axis, anywhere, none).
Scene RandomScene(ObstacleKind kind, uint64_t seed, int index);

constexpr int kFamilies = 8;
constexpr const char* kFamilyNames[kFamilies] = {
    "general",         "on a grid", "sphere",         "parallel",
    "nearly parallel", "centred",   "without radius", "limb at a large obstacle"};

}  // namespace hazumi::test
