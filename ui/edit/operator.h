#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"
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

}  // namespace hazumi::edit
