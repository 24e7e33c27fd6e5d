#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "engine/figure/figure.h"

namespace hazumi::bench {

// The figure on a free root above a floor at z = 0: the same bodies, its capsules as what touches
// the floor and nothing else, friction 0.8, its joints as hinges within their limits. All options
// are MuJoCo's defaults, of contacts and limits too.
// Coordinates: those of the free joint, then the figure's joints in order.
std::shared_ptr<mjModel> LoadMujocoFall(const Figure& figure);

}  // namespace hazumi::bench
