#pragma once

#include <functional>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/passive/contact/contact_spec.h"
#include "engine/passive/region_model.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// What of an island, whose model lists its joints, may touch planes and boxes of the scene: the
// capsules of all joints that `touches` says so of.
ContactSpec ContactsOf(const RegionModel& model, const Figure& figure,
                       const std::vector<SceneObject>& scene,
                       const std::function<bool(JointIndex)>& touches);

}  // namespace hazumi
