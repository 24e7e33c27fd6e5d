#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/project/fields/field.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {

// Names of the things of a kind that a session's project has; empty if they have no names.
std::vector<std::string> NamesOf(Thing thing, const edit::Session& session);
// Number of things of a kind that parameters call by their number; nothing: they have names.
std::optional<size_t> CountOf(Thing thing, const Project& project);
// Whether a project has any thing of a kind, or the kind has neither names nor numbers.
bool HasAny(Thing thing, const edit::Session& session);

}  // namespace hazumi::test
