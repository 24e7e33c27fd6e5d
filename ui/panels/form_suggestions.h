#pragma once

#include <string>

#include "ui/edit/parameters.h"
#include "ui/edit/session.h"

namespace hazumi::ui {

// What is meant most of the time by a parameter of an action or operator: the frames from the
// current one to the last, what is selected, what the project says now. Null: nothing can be
// guessed.
edit::Json Suggestion(const std::string& id, const edit::ParameterInfo& info,
                      edit::Session* session);

}  // namespace hazumi::ui
