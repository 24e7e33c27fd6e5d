#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/edit/parameters.h"

namespace hazumi::edit {
class Session;
}

namespace hazumi::ui {

// A value that is typed, chosen or ticked.
struct FormField {
  edit::ParameterInfo info;
  std::string text;      // empty: not given
  bool yes = false;      // kYesNo
  bool is_main = false;  // required, or what the form is for; the others are shown behind
};

// The parameters of an action or operator, before it runs.
struct FormState {
  std::string id;
  std::vector<FormField> fields;  // those that are required go first, then the other main ones
  std::string filter;             // typed into the list that is open
  int at_option = 0;              // of what the filter leaves: what Enter takes
  std::string error;
  float height = 0.0f;  // of its rows, when they were drawn last [px]
};

// Fields that share a line, such as the first and the last frame.
struct FormRow {
  std::string label;  // a key of the catalogue
  std::vector<FormField*> fields;
};
// What is to be filled in, as far as it matters with what else was chosen.
std::vector<FormRow> RowsOf(FormState* form);
// Whether a field matters: a figure that keys place has no pin.
bool IsAsked(const FormState& form, const FormField& field);

// Fields for what an action or operator takes, with what `given` and the session suggest: the
// current frame, what is selected. A drag has no field.
FormState MakeForm(const std::string& id, const edit::Json& given, edit::Session* session);
// Whether it cannot run, or does nothing, before something more is given.
bool NeedsForm(const std::string& id, const edit::Json& given);
// What an action or operator takes; empty if there is no such thing.
const std::vector<edit::ParameterInfo>& ParametersOf(const std::string& id);

// A value as it is typed into a field.
std::string TextOf(const edit::Json& value);
// Names or numbers in a list, which commas separate.
std::vector<std::string> Parts(const std::string& text);
// What was typed, as parameters. Names and numbers in lists are separated by commas. Error: the
// place is the parameter.
Result<edit::Json> ValuesOf(const FormState& form);

}  // namespace hazumi::ui
