#pragma once

#include <vector>

#include "engine/bake/rotation_state.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/region_model.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Adds the forces from outside that act at time t [s] on links of an island, whose model lists its
// joints if there are any (ModelRequest::lists_joints).
void AddOuterForces(const Animation& animation, const Figure& figure, double t,
                    const RegionModel& model, std::vector<ForceSpec>* forces);

// An impulse changes the rates of the free joints of a figure whose joints do as `request` says,
// and the velocity of its centre of mass in flight: `state`, by Coordinate. False if no free joint
// carries the point, and nothing flies. [METHOD 9.3]
bool Push(const PushForce& push, const Figure& figure, ModelRequest request, RotationState* state);

}  // namespace hazumi
