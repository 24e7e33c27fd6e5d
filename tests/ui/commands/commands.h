#pragma once

#include <string>
#include <vector>

#include "ui/edit/operator.h"
#include "ui/panels/commands/actions.h"

namespace hazumi::test {

// Something that `hazumi --operators` lists.
struct Command {
  std::string id;
  std::vector<edit::ParameterInfo> parameters;
};

inline std::vector<Command> AllCommands() {
  std::vector<Command> all;
  for (const edit::Operator& op : edit::AllOperators()) all.push_back({op.id, op.parameters});
  for (const ui::Action& action : ui::AllActions()) all.push_back({action.id, action.parameters});
  return all;
}

}  // namespace hazumi::test
