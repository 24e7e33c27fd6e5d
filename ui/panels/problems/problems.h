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

// Why there is no motion, else what the bake warned of, velocity jumps, keys that hold a falling
// body's turn, constraints that nothing feels any more, frames in the ground, feet that slide, what
// is thrown into things, bodies that are jerked as they take off or land, while efforts are shown
// the frames in which the figure is carried or turned by nothing, and what flights say of time.
// What takes long to find comes when it is found.
std::vector<Problem> ProblemsOf(Editor* editor);
// Whether there are any; costs a redraw next to nothing.
bool HasProblems(Editor* editor);

// Shows the frame, and selects what it is about.
void GoTo(const Problem& problem, Editor* editor);
// One click: to the frame, and the operator there. False: it was refused, and the editor says why.
bool Apply(const Cure& cure, Editor* editor);

}  // namespace hazumi::ui
