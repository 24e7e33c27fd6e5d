#pragma once

#include <cstdint>
#include <random>

#include "engine/spatial/types.h"

namespace hazumi::test {

// A seeded source of numbers that gives the same ones with every standard library.
class Random {
 public:
  explicit Random(uint64_t seed) : bits_(seed) {}

  double Uniform(double low, double high);
  double LogUniform(double low, double high);
  int Integer(int low, int high);  // both included
  bool Chance(double probability) { return Uniform(0.0, 1.0) < probability; }
  VecX Vector(int size, double bound);  // entries in [-bound, bound]
  Vec3 Vector3(double bound) { return Vector(3, bound); }
  Mat3 Rotation();  // uniform over all rotations
  // Inertia about the CoM of a body of this mass and about this size, in random axes.
  Mat3 Inertia(double mass, double size);

 private:
  std::mt19937_64 bits_;
};

}  // namespace hazumi::test
