#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// What rows do to each other: forces l make of them
//   w = A l + b,
// velocities or accelerations of points in contact, of hinges at limits and of gaps. A is positive
// semidefinite but for columns of contacts that slide in a known direction.
struct ConeProblem {
  enum class Kind {
    kBoth,     // one row: w = 0
    kPush,     // one row: l >= 0, w >= 0, l w = 0
    kContact,  // three: n as kPush, and |l_t| <= friction l_n, against w_t where it slides
  };
  struct Block {
    Kind kind;
    int row;  // its first one
    double friction = 0.0;
  };

  MatX A;
  VecX b;
  std::vector<Block> blocks;
};

// Each of the following searches adds its number of multiplications to `products` if that is given.

// False if no forces are found that fulfil all of it to 1e-6 of the largest; `forces` are then the
// best known ones, which push only, and stay in their cones.
bool SolveCones(const ConeProblem& problem, VecX* forces, double* products = nullptr);

// The same, for less: from inside of the cones alone, to 1e-6, and so that velocities that they
// change do negative work. False: `forces` are as they were.
bool SolveConesInside(const ConeProblem& problem, VecX* forces, double* products = nullptr);

// The same, from forces of which most push and slide where they should, by Newton's steps alone.
bool SolveConesNear(const ConeProblem& problem, VecX* forces, double* products = nullptr);

// Goes on from forces that are near, block by block, until a sweep changes them by 1e-6 of the
// largest force or less, or for `most` sweeps. They push only and stay in their cones; work done by
// velocities that they change is negative however far they come. Returns what the last one of all
// changed, of the largest force, and 0 where it was no more than that.
double SweepCones(const ConeProblem& problem, int most, VecX* forces, double* products = nullptr);

}  // namespace hazumi
