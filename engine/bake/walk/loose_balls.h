#pragma once

#include <functional>
#include <vector>

#include "engine/bake/walk/energy_account.h"
#include "engine/placement/figure_motion.h"
#include "engine/region/region_model.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// Balls that fly while links that touch things are moved may meet any link of the figure: with
// these ties the links that touch are one island, and those that keys move are known to it.
void AppendTiesForBalls(const Figure& figure, const std::function<bool(JointIndex)>& touches,
                        std::vector<ModelRequest::Tie>* ties);

// Adds these balls to the island of those links; others are left as they are.
void AddBalls(const std::vector<HeldObject>& objects, const std::vector<LooseObject>& balls,
              const Figure& figure, const std::function<bool(JointIndex)>& touches,
              RegionModel* model);

// Energy of the balls that are not among the others.
EnergyAccount::Stored EnergyOfBalls(const std::vector<HeldObject>& objects,
                                    const std::vector<LooseObject>& balls,
                                    const std::vector<LooseObject>& others, double gravity);

}  // namespace hazumi
