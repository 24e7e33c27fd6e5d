#pragma once

// Frames of a figure at random, placed by the kernels of every instruction set that runs here.

#include <vector>

#include "engine/analysis/placed_frames.h"
#include "engine/spatial/lanes/cpu.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

inline std::vector<EffortKernels> AllKernels() {
  std::vector<EffortKernels> all = {BaselineEffortKernels()};
  if (CpuHasAvx2()) all.push_back(Avx2EffortKernels());
  return all;
}

struct Stance {
  Pose X_WR;
  VecX q;
};

inline std::vector<Stance> RandomStances(const Figure& figure, int count, Random* random) {
  std::vector<Stance> stances;
  for (int i = 0; i < count; ++i) {
    stances.push_back({RandomMovingRoot(random).X_WR(), RandomAngles(figure, random)});
  }
  return stances;
}

inline PlacedFrames PlaceAll(const Figure& figure, const std::vector<Stance>& stances,
                             const EffortKernels& kernels) {
  PlacedFrames placed(figure, stances.size(), kernels);
  for (const Stance& stance : stances) placed.Add(stance.X_WR, stance.q.data());
  placed.Finish();
  return placed;
}

}  // namespace hazumi::test
