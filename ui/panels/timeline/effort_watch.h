#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "engine/analysis/effort.h"
#include "engine/analysis/missing_support.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Computes the muscle effort and the residual wrenches of the motion in the background
// [engine/analysis]. Uses a bake of its own, since it needs accelerations.
class EffortWatch {
 public:
  EffortWatch() = default;
  ~EffortWatch();
  EffortWatch(const EffortWatch&) = delete;
  EffortWatch& operator=(const EffortWatch&) = delete;

  // Looks at the motion if it is another one than before; while something is dragged only where
  // that is quickly done. Waits for what it finds if the session has patience without end.
  void Look(edit::Session* session);
  // Drops what is known of the motion, and ends the work on it; nothing happens if there is
  // neither.
  void Forget();
  // It is at work.
  bool is_busy() const { return job_ != nullptr; }

  // Of the motion that was looked at last; none of another document. Of a frame of the project:
  // null where nothing is known.
  const FrameEffort* At(int frame) const;
  bool is_there() const { return !effort_.frames.empty(); }
  // Frames with a residual wrench, of the motion evaluated last.
  const std::vector<MissingSupport>& missing() const { return missing_; }
  // Counts up with every other effort.
  long number() const { return number_; }

 private:
  struct Version {
    long document = -1, revision = -1;
    bool operator==(const Version&) const = default;
  };
  struct Job {
    Version of;
    Animation animation;
    Effort effort;
    std::vector<MissingSupport> missing;
    double seconds = 0.0;  // that it took
    std::atomic<bool> cancel = false, has_ended = false;
    std::thread thread;
  };
  void Begin(const Animation& animation, Version version);
  void End();

  Version seen_;
  long shown_ = -1;  // document that the effort is of
  int first_frame_ = 0;
  Effort effort_;
  std::vector<MissingSupport> missing_;
  long number_ = 0;
  double seconds_ = 0.0;  // that the last one took
  std::unique_ptr<Job> job_;
};

// Whether any muscle of a figure has a strength that is known.
bool HasStrengths(const Figure& figure);
// The largest share of a strength among some hinges in a row; negative: none is known.
double LargestShare(const FrameEffort& effort, JointIndex first, int count);

}  // namespace hazumi::ui
