#include "ui/edit/session/background_bake.h"

#include <chrono>
#include <new>

namespace hazumi::edit {

namespace {

BakeOptions OptionsWith(const std::atomic<bool>* cancel) {
  BakeOptions options;
  options.cancel = cancel;
  return options;
}

// Nothing where there is not enough memory for two.
Motion Copy(const Motion& motion) {
  try {
    return motion;
  } catch (const std::bad_alloc&) {
    return Motion();
  }
}

Error NotYet(bool is_stopped) {
  return {ErrorCode::kInterrupted, "", "",
          is_stopped ? "the motion is not computed: it was stopped; undo, or compute it again"
                     : "the motion is still being computed; wait, or undo"};
}

}  // namespace

BackgroundBake::BackgroundBake(const Animation& animation)
    : bake_(animation, OptionsWith(&cancel_)), last_frame_(animation.last_frame) {}

BackgroundBake::~BackgroundBake() {
  if (!thread_.joinable()) return;
  cancel_ = true;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void BackgroundBake::Update(const Animation& animation) {
  Interrupt();
  is_beside_ = is_stopped_ = false;
  error_.reset();
  last_frame_ = animation.last_frame;
  bake_.Update(animation);
}

std::optional<Error> BackgroundBake::BakeTo(int frame, std::optional<double> patience) {
  if (is_beside_) {
    if (!WaitFor(patience ? 0.0 : 1e9)) return NotYet(false);
    is_beside_ = false;
    Outcome(last_frame_);
  }
  if (bake_.is_fresh(frame)) return std::nullopt;
  if (error_) return error_;
  if (is_stopped_) return NotYet(true);
  if (!patience) {
    found_ = bake_.BakeTo(frame);
    return Outcome(frame);
  }
  Start(frame);
  if (WaitFor(*patience)) return Outcome(frame);
  Interrupt();
  if (bake_.is_fresh(frame)) return std::nullopt;
  shown_ = Copy(bake_.motion());
  is_beside_ = true;
  Start(last_frame_);
  return NotYet(false);
}

void BackgroundBake::Stop() {
  if (!is_busy()) return;
  Interrupt();
  is_beside_ = false;
  is_stopped_ = true;
}

// What became of the last bake, when the thread rests.
std::optional<Error> BackgroundBake::Outcome(int frame) {
  if (found_ && found_->code != ErrorCode::kInterrupted) error_ = found_;
  return bake_.is_fresh(frame) ? std::nullopt : found_;
}

void BackgroundBake::Start(int frame) {
  if (!thread_.joinable()) thread_ = std::thread([this] { Work(); });
  {
    const std::lock_guard lock(mutex_);
    wanted_ = frame;
    is_running_ = true;
  }
  wake_.notify_one();
}

bool BackgroundBake::WaitFor(double seconds) {
  std::unique_lock lock(mutex_);
  return rest_.wait_for(lock, std::chrono::duration<double>(seconds),
                        [this] { return !is_running_; });
}

void BackgroundBake::Interrupt() {
  cancel_ = true;
  {
    std::unique_lock lock(mutex_);
    rest_.wait(lock, [this] { return !is_running_; });
  }
  cancel_ = false;
}

void BackgroundBake::Work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return is_over_ || is_running_; });
    if (is_over_) return;
    const int frame = wanted_;
    lock.unlock();
    std::optional<Error> error = bake_.BakeTo(frame);
    lock.lock();
    found_ = std::move(error);
    is_running_ = false;
    rest_.notify_one();
  }
}

}  // namespace hazumi::edit
