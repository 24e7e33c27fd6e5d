#pragma once

#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/dynamics_region.h"
#include "ui/panels/viewport/gizmo.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Of the end of a limb: its last joint.
struct StartSpeed {
  JointIndex joint;
  Vec3 point;     // [m, world]
  Vec3 velocity;  // [m/s, world]
};

// Of all limbs that a region moves, on its first frame, `start`.
std::vector<StartSpeed> StartSpeeds(const DynamicsRegion& region, const MotionFrame& start,
                                    const Figure& figure);

// Those of the region whose bar was clicked, as arrows.
void DrawStartSpeeds(Editor* editor, const View& view);

}  // namespace hazumi::ui
