#pragma once

#include <functional>
#include <vector>

#include "engine/bake/walk/own_pairs.h"
#include "engine/figure/figure.h"
#include "engine/passive/contact/contact_spec.h"
#include "engine/passive/region_model.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What of an island, whose model lists its joints, may touch: with planes and boxes of the scene,
// the capsules of all joints that `touches` says so of, and its balls; with each other, those of
// `own`, and each ball with all capsules that it knows of. What those of the animation's
// `constraints` tie that act then passes through each other.
ContactSpec ContactsOf(const RegionModel& model, const Figure& figure, const Animation& animation,
                       const std::function<bool(JointIndex)>& touches,
                       const std::vector<LinkPair>& own, const std::vector<int>& constraints);

}  // namespace hazumi
