#pragma once

#include <optional>
#include <vector>

#include "engine/bake/bake_context.h"
#include "engine/bake/handover/placement_handover.h"
#include "engine/bake/handover/region_handover.h"
#include "engine/bake/handover/seam_finder.h"
#include "engine/bake/stretch.h"
#include "engine/bake/walk/exact_walk.h"
#include "engine/bake/walk/paper_walk.h"
#include "engine/bake/walk/refinements.h"

namespace hazumi {

// Goes through an animation, stretch by stretch. Between two frames the same regions, holds and
// placement are active; they change at frames only. What lies between is walked by the method of
// the regions that are active, else by that of the file.
class Baker {
 public:
  // The motion that it fills: its frames and the reports of its regions. The threads that help.
  Baker(const Animation& animation, const BakeOptions& options, Motion* motion, ThreadPool* pool);

  // The animation's first frame.
  Result<Checkpoint> Begin();
  // Bakes from stretch->start up to the next checkpoint, which is returned unless the animation
  // ends before. Regions are not solved anew where one of the logs in `known` tells what they do;
  // null: nothing will be asked again, and no logs are kept.
  Result<std::optional<Checkpoint>> BakeStretch(const KnownLogs* known, Stretch* stretch);

  // Work of everything baked so far, including what failed.
  double work() const { return exact_.work().total() + paper_.work().total(); }
  // Whether BakeStretch returned an error because of BakeOptions::most_work.
  bool ended_early() const { return context_.ended_early.has_value(); }
  // Removes the frames that were not baked, if the bake ended early; returns the warning of that.
  std::optional<Warning> EndEarly();

  // A curve of the animation is about to change its keys, or has changed them.
  void RemoveKeys(const Keys& keys) { context_.schedule.RemoveKeys(keys); }
  void AddKeys(const Keys& keys) { context_.schedule.AddKeys(keys); }
  // Regions of the animation have changed, but not their number.
  void RegionsChanged();

 private:
  Checkpoint Save(int frame);
  void Restore(const Checkpoint& checkpoint);
  Result<int> AdvanceToCheckpoint(int frame);
  Result<std::optional<Checkpoint>> BakeOnce(const Checkpoint& start);
  Result<std::optional<Checkpoint>> BakeWithRefinements(Stretch* stretch);
  void WarnOfOpenAccount(int region);

  // At a frame.
  std::optional<Error> CrossFrame(int frame);
  void TellStart(int frame);
  void SetAcceleration(int frame, const MotionAcceleration& acceleration);
  bool EndHolds(int frame);
  bool BeginHolds(int frame);
  bool HandOverObjects(int frame);
  void LeaveRootToContacts(int frame);
  std::optional<Error> ReleaseAsItSetsOut(int frame);
  bool ChangeForces(int frame);
  std::optional<Error> Push(int frame);
  void WarnOfJump(int frame, const ObjectChange& change, double jump);
  void WarnIfLetGoInside(int frame, size_t object);
  void ChooseWalk(int frame);
  RegionWalk& WalkOf(Method method);

  const Animation& animation_;
  const SolverRules rules_;
  Motion* motion_;
  BakeContext context_;
  RegionHandover regions_;
  PlacementHandover placement_;
  SeamFinder seams_;
  Refinements refinements_;
  ExactWalk exact_;
  PaperWalk paper_;
  RegionWalk* walk_;  // one of the two
};

}  // namespace hazumi
