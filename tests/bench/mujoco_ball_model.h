#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "engine/figure/figure.h"

namespace hazumi::bench {

// The figure on a fixed root with a ball joint for every three hinges. (test::MujocoFigure has
// hinges throughout.) Frames must be parallel and inertias diagonal, as in the test figures.
std::shared_ptr<mjModel> LoadMujocoModelWithBalls(const Figure& figure);

}  // namespace hazumi::bench
