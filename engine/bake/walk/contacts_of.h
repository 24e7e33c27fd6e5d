#pragma once

#include <functional>
#include <vector>

#include "engine/bake/walk/own_pairs.h"
#include "engine/figure/figure.h"
#include "engine/region/contact/contact_spec.h"
#include "engine/region/region_model.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Returns those of the `constraints`, by index, whose two ends do not collide with each other.
std::vector<const Constraint*> PartingConstraints(const Animation& animation,
                                                  const std::vector<int>& constraints);
// Returns whether a constraint removes the contacts between two links, or a link and an object of
// the scene, by index. An end has its links and all links beyond them.
bool AreParted(const LinkPair& pair, const Constraint& constraint, const Figure& figure);
bool IsParted(int link, int object, const Constraint& constraint, const Figure& figure);

// Returns the contacts of an island, whose model lists its joints. The capsules of all joints for
// which `touches` returns true, and the balls, collide with planes and boxes of the scene. The
// pairs `own` collide with each other, and each ball with all capsules. Bodies that active
// `constraints` of the animation tie do not collide.
ContactSpec ContactsOf(const RegionModel& model, const Figure& figure, const Animation& animation,
                       const std::function<bool(JointIndex)>& touches,
                       const std::vector<LinkPair>& own, const std::vector<int>& constraints);

}  // namespace hazumi
