#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/edit/parameters.h"

namespace hazumi::edit {
class Session;
}

namespace hazumi::ui {

// A value that is typed or ticked.
struct FormField {
  edit::ParameterInfo info;
  std::string text;  // empty: not given
  bool yes = false;  // kYesNo
};

// The parameters of an action or operator, before it runs.
struct FormState {
  std::string id;
  std::vector<FormField> fields;  // those that are required go first
  std::string error;
};

// Fields for what an action or operator takes, with what `given` and the session suggest: the
// current frame, what is selected. A drag has no field.
FormState MakeForm(const std::string& id, const edit::Json& given, edit::Session* session);
// Whether it cannot run before something more is given.
bool NeedsForm(const std::string& id, const edit::Json& given);
// What an action or operator takes; empty if there is no such thing.
const std::vector<edit::ParameterInfo>& ParametersOf(const std::string& id);

// What was typed, as parameters. Names and numbers in lists are separated by commas. Error: the
// place is the parameter.
Result<edit::Json> ValuesOf(const FormState& form);

}  // namespace hazumi::ui
