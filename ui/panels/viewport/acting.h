#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What acts on the figure beside its joints in the frame that is shown: constraints, and forces
// from outside. Places are in the world [m].

struct ConstraintMark {
  int index = 0;  // of Project::constraints
  Vec3 a, b;      // where its ends are
  // What is still missing: of a distance from its length [m], of a weld its turn too [rad].
  double gap = 0.0, turn = 0.0;
  double force = 0.0;  // from here on [N]; 0 where it acts on nothing
  bool is_broken = false;

  bool is_open() const;
};
// Those whose frames the figure's is among; on the last frame of all what ends there is seen, too.
std::vector<ConstraintMark> ConstraintMarks(const Animation& animation, const Motion& motion,
                                            const PosedFigure& figure);

struct ForceMark {
  int index = 0;  // of Project::forces
  ForceKind kind = ForceKind::kWind;
  // An arrow, whose length tells how strong it is; of an attraction from what is pulled to where.
  Vec3 from, to;
  double strength = 0.0;  // of wind [m/s], of an attraction here [N], of a push [N s]
};
std::vector<ForceMark> ForceMarks(const Animation& animation, const PosedFigure& figure);
// "8.0 m/s"
std::string TextOf(const ForceMark& mark);

// The nearest one whose line is within reach, or null.
const ConstraintMark* ConstraintAt(const View& view, Point at,
                                   const std::vector<ConstraintMark>& marks, double scale);
const ForceMark* ForceAt(const View& view, Point at, const std::vector<ForceMark>& marks,
                         double scale);
// "grip: 120 N", "grip: 2.1 cm apart", "grip: broken".
std::string TextOf(const ConstraintMark& mark, const Project& project);

// All of them, unless they are hidden.
void DrawActing(Editor* editor, const View& view, const PosedFigure& figure);
// What there is to say of the constraint under the mouse, or else of the force, or of what touches
// something; empty: none is.
std::string ActingAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse);
// The bar of the constraint under the mouse becomes the chosen one. False if none is there.
bool ChooseConstraintAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse);

}  // namespace hazumi::ui
