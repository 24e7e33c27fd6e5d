#pragma once

// Internal: what constraints say of objects, of the scene or held.

#include <string>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// Constraints name it as it is called now.
void RenameObject(const std::string& from, const std::string& to, Project* project);

// Errors: kSchema if a constraint is fixed to it.
Result<Done> ExpectUnconstrained(const std::string& object, const Project& project);

}  // namespace hazumi::edit
