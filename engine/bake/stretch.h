#pragma once

#include <optional>
#include <vector>

#include "engine/bake/island_solution.h"
#include "engine/bake/motion.h"
#include "engine/bake/pose/active_holds.h"
#include "engine/bake/pose/held_objects.h"
#include "engine/bake/pose/root_placement.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

// All that the rest of a bake depends on besides the animation: the figure at a frame, before
// anything there ends or begins, while no region is active.
struct Checkpoint {
  int frame = 0;
  FigureMotion now;
  MotionLimit before;
  std::vector<CurveTrack::Piece> pieces;  // that lead there: of all joints, then of the root
  std::optional<size_t> span;             // index of Animation::placements
  RootPlacementState placement;
  std::vector<ActiveHolds::Begun> holds;
  std::vector<ObjectState> objects;
  bool operator==(const Checkpoint&) const = default;
};

// A part of a bake: from a checkpoint up to the next, or to the end. It depends on its beginning
// and on the animation, on nothing else.
struct Stretch {
  Checkpoint start;
  std::vector<MotionEvent> events;
  std::vector<Warning> warnings;
  std::vector<PlacementJump> placement_jumps;
  std::vector<Seam> seams;
  IslandLogs logs;  // of the exact regions in it

  void AppendTo(Motion* motion) const {
    motion->events.insert(motion->events.end(), events.begin(), events.end());
    motion->warnings.insert(motion->warnings.end(), warnings.begin(), warnings.end());
    motion->placement_jumps.insert(motion->placement_jumps.end(), placement_jumps.begin(),
                                   placement_jumps.end());
    motion->seams.insert(motion->seams.end(), seams.begin(), seams.end());
  }
};

}  // namespace hazumi
