#include "ui/panels/timeline/playback.h"

#include <algorithm>
#include <cmath>

namespace hazumi::ui {

namespace {

constexpr long kMostBehind = 4;  // frames

}  // namespace

void Playback::Start(double now, int frame, int first, int last, double rate) {
  is_on_ = true;
  start_ = window_start_ = now;
  rate_ = rate;
  first_ = first;
  last_ = std::max(first, last);
  start_frame_ = std::clamp(frame, first_, last_);
  passed_ = 0;
  last_shown_ = -1;
  shown_ = frames_ = dropped_ = 0;
  shown_rate_ = 0.0;
}

double Playback::FrameAt(double now) const {
  const double length = last_ - first_ + 1;
  return first_ + std::fmod(start_frame_ - first_ + (now - start_) * rate_, length);
}

int Playback::Advance(double now) {
  const long due = std::lround(std::floor((now - start_) * rate_ + 1e-6));
  if (due > passed_ + kMostBehind) {
    passed_ = due;
  } else if (due > passed_) {
    ++passed_;
  }
  const long length = last_ - first_ + 1;
  return first_ + static_cast<int>((start_frame_ - first_ + passed_) % length);
}

void Playback::CountFrame(double now, int frame) {
  if (frame == last_shown_) return;
  if (last_shown_ >= 0) {
    const int length = last_ - first_ + 1;
    dropped_ += ((frame - last_shown_) % length + length) % length - 1;
  }
  last_shown_ = frame;
  ++shown_;
  ++frames_;
  if (now - window_start_ < 1.0) return;
  shown_rate_ = shown_ / (now - window_start_);
  window_start_ = now;
  shown_ = 0;
}

}  // namespace hazumi::ui
