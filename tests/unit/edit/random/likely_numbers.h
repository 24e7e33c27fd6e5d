#pragma once

#include <string>

#include "ui/edit/session/session.h"

namespace hazumi::test {

struct Likely {
  double low, high;
};

// Between which numbers a parameter is likely to be, by its name and that of its operator, else by
// its range.
Likely LikelyRange(const std::string& id, const edit::ParameterInfo& info,
                   const edit::Session& session);

// Where time goes on: what else is called so means no frame.
bool IsFrame(const std::string& name);

}  // namespace hazumi::test
