#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/panels/sheet/state.h"
#include "ui/panels/timeline/effort_watch.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

struct GraphLayout;

// The torque that the motion needs in a shown hinge.
struct TorqueCurve {
  int curve = 0;                                  // of the graph's
  std::vector<std::pair<double, double>> points;  // frame and torque [N m]
};

// What muscles can give in a frame: torques from low to high [N m].
struct StrengthBand {
  double frame = 0.0, low = 0.0, high = 0.0;
};

// The torques of the shown hinges, below the graph's curves.
struct TorquePanel {
  Rect rect;
  ValueRange values;  // [N m], from the lower to the upper edge
  std::vector<TorqueCurve> curves;
  // Of the active hinge, else of the first one that is shown; empty: its strength is not known.
  std::optional<JointIndex> band_of;
  std::vector<StrengthBand> band;

  float YOf(double torque) const;
};

// In the lower part of `rect`. `motion` may be null.
TorquePanel LayOutTorque(edit::Session* session, const Motion* motion, const EffortWatch& effort,
                         const GraphLayout& graph, const std::string& active, const Rect& rect);
// How much of the height it takes.
inline constexpr double kTorqueShare = 0.4;

// The share of a hinge's strength that its region lets it use in a frame: 1 where no spring says
// less.
double MuscleShareAt(const Animation& animation, JointIndex hinge, double frame);

// "r_elbow_flexion   frame 12   23.4 N m, 45 % of its strength"; empty: nothing is known there.
std::string TorqueTextAt(const EffortWatch& effort, const GraphLayout& graph, Point p);

}  // namespace hazumi::ui
