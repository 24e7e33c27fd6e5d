#pragma once

#include <string>
#include <vector>

#include "ui/edit/parameters.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// A value that a form offers.
struct FormOption {
  std::string value;  // as it is typed
  std::string label;  // a key of the catalogue, or a name
  std::string group;  // the limb, a key of the catalogue; empty: none
  bool operator==(const FormOption&) const = default;
};

// What a parameter may be, in the project as it is; empty if anything.
std::vector<FormOption> OptionsOf(const edit::ParameterInfo& info, const edit::Session& session);

// Those whose label contains what was typed, upper case as lower; all if nothing was.
std::vector<FormOption> Filtered(const std::vector<FormOption>& options, const std::string& typed);

}  // namespace hazumi::ui
