#pragma once

#include <string>
#include <vector>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What would put something right: an operator, with what it is given, at a frame.
struct Cure {
  std::string operator_id;
  Json parameters = Json::object();
  double frame = 0.0;
  std::string label;  // empty: that of the operator
};

// Something about the motion that an animator would not want.
struct Problem {
  std::string text;  // a sentence, in the language of the interface; the engine's own are English
  double frame = 0.0;
  std::string joint;      // to be selected; empty: none
  ItemId region;          // to be shown; unset: none
  bool is_error = false;  // there is no motion because of it
  std::vector<Cure> cures;
};

// Problems of the project: the error that prevents a motion, or the warnings of the bake, velocity
// jumps, keys that hold the orientation of a falling body, constraints without effect, frames below
// the ground, sliding feet, thrown objects that enter others, jerks at take-off or landing, frames
// with a residual wrench (while efforts are shown), and implausible flight times. Problems that
// take long to find are added once found.
std::vector<Problem> ProblemsOf(Editor* editor);
// Whether there are any; costs a redraw next to nothing.
bool HasProblems(Editor* editor);

// Shows the frame, and selects what it is about.
void GoTo(const Problem& problem, Editor* editor);
// One click: to the frame, and the operator there. False: it was refused, and the editor says why.
bool Apply(const Cure& cure, Editor* editor);

}  // namespace hazumi::ui
