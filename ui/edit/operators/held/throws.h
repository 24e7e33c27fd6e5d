#pragma once

// Internal: what aiming a throw and making one share.

#include <memory>
#include <optional>

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/held/throw_aim.h"

namespace hazumi::edit {

// Hinges from the holder to the root that the region moves and lets go by itself.
std::vector<JointIndex> FreeHinges(const DynamicsRegion& region, GroupIndex holder,
                                   const Animation& animation);

// Whether a dynamics region moves who lets go of the object next, so that its throw can be aimed.
bool HasThrow(int object, Session* session);

// The region starts as fast as it has to, and what is thrown lies on the spot from when it comes
// down: `ground` is where it touches, by default as high as it has to rise [m]. Errors: those of
// ThrowAim, and what would help.
Result<Done> ThrowTo(const Vec3& ground, std::optional<double> height, const ThrowCase& of,
                     std::shared_ptr<const Figure> figure, Project* project);

}  // namespace hazumi::edit
