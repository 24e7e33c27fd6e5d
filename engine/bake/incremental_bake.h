#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>

#include "engine/bake/bake.h"
#include "engine/bake/baker.h"

namespace hazumi {

// The motion of an animation that is being edited. What an edit cannot have changed is kept: the
// bake goes on from the last checkpoint before the first frame that the edit can reach, joins what
// was there as soon as nothing differs any more, and solves again only those groups of a region
// that feel a difference. Frames are baked when they are asked for. The result is bit-equal to that
// of Bake.
class IncrementalBake {
 public:
  explicit IncrementalBake(Animation animation, const BakeOptions& options = {});

  // The animation was edited. Cheap where only keys changed, or settings of regions.
  void Update(const Animation& animation);

  // Bakes everything up to and including a frame of the animation, as far as that is not done.
  // After an error, as Bake gives it, everything before the frame that it names is there, or where
  // memory does not suffice nothing at all; the next try comes with the next edit.
  std::optional<Error> BakeTo(int frame);
  std::optional<Error> Finish() { return BakeTo(animation_.last_frame); }

  // True if the frame is what Bake would give.
  bool is_fresh(int frame) const { return frame < fresh_until_; }
  // Frames before this one are fresh. May be asked by any thread.
  int fresh_until() const { return fresh_until_; }
  // Frames that are not fresh are as they were before the edit. Events and warnings are in order.
  const Motion& motion() const { return motion_; }

  // Stretches baked so far, by all edits.
  int stretches_baked() const { return stretches_baked_; }

 private:
  // Frames that an edit can reach.
  struct Reach {
    double first, last;
    void Include(double frame) {
      first = std::min(first, frame);
      last = std::max(last, frame);
    }
  };

  // A stretch, and whether it has to be baked again from its start.
  struct Part {
    Stretch stretch;
    bool is_stale = true;
  };
  using Parts = std::map<int, Part>;  // by first frame

  void StartAnew(const Animation& animation);
  void Forget(const Error& error);
  std::optional<Error> BakeFurther(int frame);
  void ChangeKeys(const Keys& next, Keys* keys, Reach* reach);
  void ChangeRegions(const Animation& next, Reach* reach);
  void IncludeBlends(Reach* reach) const;
  void MakeStale(const Reach& reach);
  void KeepLogs(const Stretch& stretch);
  std::optional<Error> Begin();
  std::optional<Error> BakeStaleStretch();
  void Join(std::optional<Checkpoint> next);
  void CollectEvents();

  Animation animation_;
  BakeOptions options_;
  Team team_;
  Motion motion_;
  std::unique_ptr<Baker> baker_;
  Parts parts_;
  bool has_begun_ = false;  // the first part's start is right
  // Where the first stale part begins, whose start is right; those of later ones may not be.
  std::atomic<int> fresh_until_ = 0;
  KnownLogs known_;  // of stretches that are no more
  std::optional<Error> error_;
  int stretches_baked_ = 0;
};

}  // namespace hazumi
