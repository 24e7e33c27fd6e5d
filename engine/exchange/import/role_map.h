#pragma once

// Roles that somebody gives bones by name, in place of those that are told.

#include <map>
#include <string>

#include "engine/base/result.h"
#include "engine/figure/body_role.h"

namespace hazumi {

using RoleMap = std::map<std::string, BodyPlace>;  // by a bone's name in its file

// "left upper_arm", "spine", "none".
std::string TextOfPlace(BodyPlace place);

// The map that a JSON text says: {"format": "hazumi-roles", "roles": {"Bip01 L UpperArm": "left
// upper_arm", ...}}. Error, kSyntax or kSchema: where the text is no such map. `file`: for
// messages.
Result<RoleMap> RolesFromText(const std::string& text, const std::string& file);
// The same of a file.
Result<RoleMap> ReadRoles(const std::string& path);

}  // namespace hazumi
