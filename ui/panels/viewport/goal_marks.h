#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Goal with a place: its point or object now, and where that is to be [m].
struct GoalMark {
  int index = 0;            // of Project::goals
  int frames = 0;           // until then; 0 in its frame, negative once it flies
  Vec3 point, place;        // [m]
  std::optional<Vec3> top;  // of the arc of what is thrown, once that is known [m]
};
// Goals of the last second before their frames; of what is thrown until it is down.
std::vector<GoalMark> GoalMarks(const Project& project, const PosedFigure& figure);
// Finds the tops of arcs in a motion that goes on behind the frames of their goals.
void FindTops(const Project& project, const Motion& motion, double gravity,
              std::vector<GoalMark>* marks);
// "reach: in 4 frames", "reach: 0.2 cm off"
std::string TextOf(const GoalMark& mark, const Project& project);

// The part of a mark under the mouse.
std::optional<GoalPart> GoalPartAt(const View& view, Point mouse,
                                   const std::vector<GoalMark>& marks, const Project& project,
                                   double scale);

// Marks of the frame that is shown; none while forces are hidden.
std::vector<GoalMark> GoalMarksNow(Editor* editor, const PosedFigure& figure);
void DrawGoals(Editor* editor, const View& view, const PosedFigure& figure);

}  // namespace hazumi::ui
