#pragma once

#include <vector>

#include "engine/region/contact/contact_spec.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// The planes and boxes of a scene for what has this coefficient of friction itself.
std::vector<ContactObstacle> ObstaclesOf(const std::vector<SceneObject>& scene, double friction);

}  // namespace hazumi
