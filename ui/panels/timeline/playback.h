#pragma once

namespace hazumi::ui {

// Playback in real time: which frame to show when, and how many were really shown. A frame that is
// late is shown all the same, and the next ones follow at once until time is caught up with; frames
// are passed over only where that would take too long.
class Playback {
 public:
  bool is_on() const { return is_on_; }
  // From `frame`, of a loop over [first, last], at so many frames a second.
  void Start(double now, int frame, int first, int last, double rate);
  void Stop() { is_on_ = false; }
  int start_frame() const { return start_frame_; }

  // Where playback should be, also between frames.
  double FrameAt(double now) const;
  // Goes on to the frame to be shown now.
  int Advance(double now);
  // When the frame that is shown was due, and when the next one is [s].
  double due() const { return start_ + static_cast<double>(passed_) / rate_; }
  double NextFrameTime() const { return start_ + static_cast<double>(passed_ + 1) / rate_; }
  double frame_seconds() const { return 1.0 / rate_; }

  // A frame was shown.
  void CountFrame(double now, int frame);
  // Different frames shown per second, over about the last second; 0 before that is known.
  double shown_rate() const { return shown_rate_; }
  // Since playback began: frames shown, and frames passed over.
  int frames() const { return frames_; }
  int dropped() const { return dropped_; }

 private:
  bool is_on_ = false;
  double start_ = 0.0, rate_ = 30.0;
  int start_frame_ = 0, first_ = 0, last_ = 0;
  long passed_ = 0;  // frames since the start
  int last_shown_ = -1, frames_ = 0, dropped_ = 0;
  double window_start_ = 0.0, shown_rate_ = 0.0;
  int shown_ = 0;
};

}  // namespace hazumi::ui
