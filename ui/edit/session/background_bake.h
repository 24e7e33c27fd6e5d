#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/bake/incremental_bake.h"

namespace hazumi::edit {

// A motion that follows an animation, of which a user never waits long: what takes longer than his
// patience goes on beside, and until it is done the motion stays as far as it was. To be used by
// one thread.
class BackgroundBake {
 public:
  explicit BackgroundBake(const Animation& animation);
  ~BackgroundBake();
  BackgroundBake(const BackgroundBake&) = delete;
  BackgroundBake& operator=(const BackgroundBake&) = delete;

  // The animation was edited: what goes on beside ends, and is begun again when it is asked for.
  void Update(const Animation& animation);

  // Bakes up to and including a frame. Waits for so many seconds, or if none are given until it is
  // done. Errors: of Bake; kInterrupted: it goes on beside, up to the last frame, or was stopped.
  std::optional<Error> BakeTo(int frame, std::optional<double> patience);
  // As far as it is baked; elsewhere as it was before, or without angles where it has never been.
  // Valid until the next call.
  const Motion& motion() const { return is_beside_ ? shown_ : bake_.motion(); }

  // Why the animation as it is has no motion, as far as it was baked.
  const std::optional<Error>& error() const { return error_; }

  // Something goes on beside. How far it is: frames before this one are done.
  bool is_busy() const { return is_beside_ && is_running_; }
  int done_until() const { return bake_.fresh_until(); }
  // Ends what goes on beside; it is begun again after the next Update or Resume.
  void Stop();
  void Resume() { is_stopped_ = false; }
  bool is_stopped() const { return is_stopped_; }

 private:
  void Work();
  void Start(int frame);
  bool WaitFor(double seconds);
  void Interrupt();
  std::optional<Error> Outcome(int frame);

  std::atomic<bool> cancel_ = false;
  IncrementalBake bake_;
  int last_frame_;
  Motion shown_;            // while is_beside_
  bool is_beside_ = false;  // the thread was left to itself
  bool is_stopped_ = false;
  std::optional<Error> error_;  // of the animation as it is

  std::mutex mutex_;  // of what follows
  std::condition_variable wake_, rest_;
  std::atomic<bool> is_running_ = false;
  bool is_over_ = false;
  int wanted_ = 0;
  std::optional<Error> found_;
  std::thread thread_;
};

}  // namespace hazumi::edit
