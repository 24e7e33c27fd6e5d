#pragma once

#include <string>
#include <vector>

#include "ui/edit/parameters.h"

namespace hazumi::ui {

// Something that can be looked for and done: an action or operator, with parameters or without.
struct Command {
  std::string id;
  edit::Json parameters = edit::Json::object();
  std::string label;    // in the interface's language
  std::string english;  // for those who look for it in English
};

// All that there is, in the interface's language: what the menus have, with their parameters, and
// every action and operator that makes sense by itself.
std::vector<Command> AllCommands();

// Those that have all words of a query in label or id, upper case as lower; the best first.
std::vector<Command> Search(const std::vector<Command>& commands, const std::string& query);

struct SearchState {
  std::string query;
  int selected = 0;
};

}  // namespace hazumi::ui
