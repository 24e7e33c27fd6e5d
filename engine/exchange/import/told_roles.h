#pragma once

// Internal. Roles of kept bones beside those that names tell.

#include <optional>

#include "engine/exchange/import/world_frame.h"

namespace hazumi {

// Tells roles by the skeleton's shape if no name tells any. Returns whether it did.
bool TellRolesByShape(const WorldFrame& world, Skeleton* skeleton);

// Gives bones roles in place of what was told; a role of which a body has one leaves the bone that
// had it. Errors, kSemantics: no kept bone of that name; a limb without its side.
std::optional<Error> GiveRoles(const RoleMap& roles, const Character& character,
                               Skeleton* skeleton);

// Warns of each part of a limb that no bone is, in a body with arms and legs: throws, jumps and
// poses leave that limb alone.
void SayMissingParts(const Skeleton& skeleton, ImportReport* report);

}  // namespace hazumi
