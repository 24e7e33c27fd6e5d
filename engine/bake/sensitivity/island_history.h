#pragma once

#include <memory>
#include <vector>

#include "engine/bake/island_request.h"
#include "engine/base/result.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// An island of a region's joints as a bake solved it: with which curves, from when to when.
struct IslandHistory {
  std::shared_ptr<const IslandTask> task;
  std::vector<Coordinate> hinges;  // free ones, as the task numbers them
  HingeState start;
  struct Piece {
    double start = 0.0, end = 0.0;  // up to where the curves are smooth [s]
    std::shared_ptr<const DrivenMotion> curves;
  };
  std::vector<Piece> pieces;  // one after the other, at least one
};

// Bakes an animation up to a frame of a region, its last one at most. Returns the islands that have
// joints of this region, in order of time; those that follow each other have the same joints, with
// other circumstances. `threads`: as BakeOptions.
Result<std::vector<IslandHistory>> BakeHistories(const Animation& animation, int region,
                                                 int last_frame, int threads);

}  // namespace hazumi
