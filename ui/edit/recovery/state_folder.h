#pragma once

#include <functional>
#include <string>

#include "engine/base/result.h"

namespace hazumi::edit {

// Where what outlives the program, and is no document, is kept: $XDG_STATE_HOME/hazumi, else
// ~/.local/state/hazumi. `variable` looks up the environment and may give null: std::getenv.
// Error: kFailed if there is no home either.
Result<std::string> StateFolder(const std::function<const char*(const char* name)>& variable);

}  // namespace hazumi::edit
