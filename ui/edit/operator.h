#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"
#include "ui/edit/parameters.h"

namespace hazumi::edit {

class Session;

// Something that a user can do: by menu, shortcut, search or script, always through this.
struct Operator {
  const char* id;     // "key.insert"
  const char* label;  // "Insert key", as menus and the undo history show it
  const char* help;   // a sentence
  std::vector<ParameterInfo> parameters;
  std::function<Result<Done>(Session*, const Parameters&)> run;
};

// All operators, by id.
const std::vector<Operator>& AllOperators();
const Operator* FindOperator(const std::string& id);

// Result of an operator: what it made and measured.
struct Outcome {
  std::vector<std::string> made;        // addresses of the items that are new (field_address.h)
  std::vector<Named<double>> measured;  // such as {"release", 12}: names say the unit
};

}  // namespace hazumi::edit
