#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/region/constraints/constraint_spec.h"
#include "engine/region/region_model.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Which of the animation's constraints act at time t [s]; `broken` are left out. By index,
// ascending.
std::vector<int> ActiveConstraints(const Animation& animation, double t,
                                   const std::vector<int>& broken);
// What they tie.
std::vector<ModelRequest::Tie> TiesOf(const Animation& animation,
                                      const std::vector<int>& constraints);

// Those of `constraints` that hold a node of an island that a region moves, and their indices.
struct IslandConstraints {
  std::vector<ConstraintSpec> specs;
  std::vector<int> indices;
  std::vector<char> are_swapped;  // its end a is the animation's b
};
IslandConstraints ConstraintsOf(const RegionModel& model, const Animation& animation,
                                const std::vector<int>& constraints);

// With what rate a gap closes [1/s]; 0: there is none to close.
double ClosingRate(const Constraint& constraint, double seconds_per_frame);

// Of a figure whose positions are computed.
ConstraintGap GapOf(const Constraint& constraint, const Figure& figure, const Pose& X_WR,
                    const DynamicsWorkspace& ws);

}  // namespace hazumi
