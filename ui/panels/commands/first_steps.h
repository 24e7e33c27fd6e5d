#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>

#include "ui/edit/parameters.h"

namespace hazumi::ui {

// Something that was done: an action or operator that succeeded, and what was then seen.
struct ExecutedCommand {
  std::string id;
  edit::Json parameters;
  double frame = 0.0;  // current
  std::set<std::string> selected_joints;
};

inline constexpr int kNumFirstSteps = 5;

// What of the five steps to a first throw has been done: three poses, a region of the arms, a
// pinned foot, and playing it.
struct FirstSteps {
  std::set<double> posed_frames;
  std::optional<double> dragged_frame;  // posed by a drag that is not over
  bool has_region = false, has_pin = false, has_played = false;

  std::array<bool, kNumFirstSteps> ticks() const;
  bool all() const;
  void TakeDragged();
};

// The steps after a deed.
FirstSteps After(FirstSteps steps, const ExecutedCommand& deed);

// What to do in a step, in English.
struct StepText {
  const char* title;
  const char* how;
};
const StepText& TextOfStep(int step);

}  // namespace hazumi::ui
