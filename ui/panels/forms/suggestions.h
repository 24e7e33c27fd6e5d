#pragma once

#include <string>

#include "ui/edit/parameters.h"
#include "ui/edit/session/session.h"
#include "ui/panels/forms/parameter_form.h"

namespace hazumi::ui {

// What is meant most of the time by a parameter of an action or operator: the frames from the
// current one to the last, what is selected, what the project says now. Null: nothing can be
// guessed.
edit::Json Suggestion(const std::string& id, const edit::ParameterInfo& info,
                      edit::Session* session);

// What the project has now of what the form may change, for a field that is left empty: the frames
// of the region that was chosen, the limits of the hinge. Empty: nothing is known.
std::string PresentValue(const FormState& form, const std::string& name,
                         const edit::Session& session);

}  // namespace hazumi::ui
