#pragma once

// Values that a form offers: all that there may be, the usual one, and the present one.

#include <string>
#include <vector>

#include "ui/edit/parameters.h"
#include "ui/edit/session/session.h"
#include "ui/panels/forms/parameter_form.h"

namespace hazumi::ui {

// A value that a form offers.
struct FormOption {
  std::string value;  // as it is typed
  std::string label;  // a key of the catalogue, or a name
  std::string group;  // the limb, a key of the catalogue; empty: none
  bool operator==(const FormOption&) const = default;
};

// Lists the values that a parameter may have in the project as it is; empty if any value may be.
std::vector<FormOption> OptionsOf(const edit::ParameterInfo& info, const edit::Session& session);

// Those whose label contains what was typed, upper case as lower; all if nothing was.
std::vector<FormOption> Filtered(const std::vector<FormOption>& options, const std::string& typed);

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
