#pragma once

#include <vector>

namespace hazumi::ui {

// What a window is measured by: how long its pictures took.
class WindowTrace {
 public:
  struct Event {
    double seconds;    // from what the user did to the finished picture
    bool has_changed;  // the project
    bool is_behind;    // the picture shows a motion from before, as the new one is still computed
    bool is_typing = false;  // a text field has the keyboard
  };
  void AddEvent(const Event& event);
  int events() const { return events_; }
  // Of events that changed the project; the others have hardly anything to draw.
  int changes() const { return static_cast<int>(changes_.size()); }
  int behind() const { return behind_; }
  // What a share of the changes kept to, in (0, 1] [s]; 0 if there is none.
  double TimeOf(double share) const;
  // Events while a text field has the keyboard, and what a share of them kept to.
  int typed() const { return static_cast<int>(typed_.size()); }
  double TypingTimeOf(double share) const;

  // Another frame of playback is shown.
  struct Frame {
    double late;      // from when it was due to the finished picture [s]
    double seconds;   // after which frames follow each other
    int passed_over;  // frames between the one before and this one that were not shown
  };
  void AddFrame(const Frame& frame);
  int frames() const { return frames_; }
  int passed_over() const { return passed_over_; }
  int late_frames() const { return late_frames_; }  // by more than a frame's time
  double latest() const { return latest_; }         // [s]

 private:
  int events_ = 0, behind_ = 0;
  std::vector<double> changes_, typed_;  // [s]
  int frames_ = 0, passed_over_ = 0, late_frames_ = 0;
  double latest_ = 0.0;
};

}  // namespace hazumi::ui
