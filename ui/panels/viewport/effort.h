#pragma once

#include <string>
#include <vector>

#include "render/motion/motion_scene.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The colours of effort: the torque in a joint as a share of its muscles' strength.

// Green where nothing is asked, yellow at the half, red where all is; darker beyond.
SrgbColor EffortColor(double share);

// By JointIndex: of what lies beyond each hinge, the largest share of its joint. See-through where
// it is not known.
std::vector<render::BoneTint> EffortTints(const Figure& figure, const FrameEffort& effort);

// A joint of which more is asked than there is.
struct EffortMark {
  GroupIndex joint;
  double share = 0.0;
};
std::vector<EffortMark> EffortMarks(const Figure& figure, const FrameEffort& effort);

// "largest effort: r_elbow 45 %", or why there is none.
std::string EffortText(const Figure& figure, const EffortWatch& effort, int frame);
// "45 % of its strength" of a joint; empty: not known, or not shown.
std::string EffortOfJoint(const Editor& editor, GroupIndex joint);

// Marks at joints, and below on the left what the colours mean. Nothing if they are not shown.
void DrawEffort(const Editor& editor, const View& view, const PosedFigure& figure);

}  // namespace hazumi::ui
