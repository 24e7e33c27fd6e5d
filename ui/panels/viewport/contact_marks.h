#pragma once

#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What pushes a figure where it touches the scene, itself or a ball, in regions that keep out of
// these.
struct ContactMark {
  ContactParts parts;
  // An arrow from where it touches, whose length tells how strong it is.
  Vec3 from, to;
  double force = 0.0;  // [N]
};
// In the frame that is shown. What next to nothing pushes has none.
std::vector<ContactMark> ContactMarks(const Animation& animation, const PosedFigure& figure);
// "r_foot, floor: 312 N"
std::string TextOf(const ContactMark& mark, const Animation& animation);

// All of them, unless they are hidden.
void DrawContacts(Editor* editor, const View& view, const PosedFigure& figure);
// What there is to say of the one under the mouse; empty: none is.
std::string ContactAt(Editor* editor, const View& view, const PosedFigure& figure, Point mouse);

}  // namespace hazumi::ui
