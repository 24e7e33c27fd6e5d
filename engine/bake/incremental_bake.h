#pragma once

#include <memory>
#include <optional>

#include "engine/bake/bake.h"

namespace hazumi {

// The motion of an animation that is being edited. What an edit cannot have changed is kept: the
// bake goes on from the last checkpoint before the first frame that the edit can reach, joins what
// was there as soon as nothing differs any more, and solves again only those islands of a region
// that feel a difference. Frames are baked when they are asked for. The result is bit-equal to that
// of Bake.
class IncrementalBake {
 public:
  explicit IncrementalBake(Animation animation, const BakeOptions& options = {});
  ~IncrementalBake();

  // The animation was edited. Cheap where only keys changed, or settings of regions.
  void Update(const Animation& animation);

  // Bakes everything up to and including a frame of the animation, as far as that is not done.
  // After an error, as Bake gives it, everything before the frame that it names is there, or where
  // memory does not suffice nothing at all; the next try comes with the next edit.
  std::optional<Error> BakeTo(int frame);
  std::optional<Error> Finish();

  // True if the frame is what Bake would give.
  bool is_fresh(int frame) const { return frame < fresh_until(); }
  // Frames before this one are fresh. May be asked by any thread.
  int fresh_until() const;
  // Frames that are not fresh are as they were before the edit. Events and warnings are in order.
  const Motion& motion() const;

  // Stretches baked so far, by all edits.
  int stretches_baked() const;
  // Work of all bakes so far (Work), also of those that failed. A solution that is kept counts
  // again where it is used again.
  double work() const;

 private:
  // The solvers and what they keep, of which whoever shows a motion knows nothing.
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace hazumi
