#pragma once

#include <deque>

struct ImGuiIO;

namespace hazumi::ui {

// What a user did with mouse or keyboard.
struct InputEvent {
  enum class Kind {
    kMove,    // of the mouse, to (x, y) [px]
    kButton,  // `code`: 0 left, 1 right, 2 middle
    kWheel,   // by (x, y) notches
    kKey,     // `code`: as in keys.h
    kText     // `code`: a letter, in Unicode
  };
  Kind kind;
  float x = 0.0f, y = 0.0f;
  int code = 0;
  bool is_down = false;
};

// What the user did and ImGui has not been told of. ImGui sees the mouse and the keys as they are
// once a frame: with what happened in a slow frame all at once, a short press would be lost, a
// click be where the mouse went afterwards, and digits in the order of their keys. So each frame
// gets as much as leaves the order plain: one button or key that goes down, and what led to it.
// Letters for a field are in order anyway, so a frame takes all that there are: who types faster
// than frames are drawn sees the text as it was typed.
class InputQueue {
 public:
  void Push(const InputEvent& event) { events_.push_back(event); }
  // Whether another frame is needed.
  bool is_empty() const { return events_.empty(); }
  // To be called before ImGui's NewFrame. `types`: a field takes what is typed.
  void Feed(bool types, ImGuiIO* io);

 private:
  bool IsLetter() const;

  std::deque<InputEvent> events_;
  int frames_to_wait_ = 0;
};

}  // namespace hazumi::ui
