#pragma once

#include <string>
#include <vector>

#include "engine/project/project.h"

namespace hazumi::edit {

// Result of an operator: what it made and measured.
struct Outcome {
  std::vector<std::string> made;        // addresses of the items that are new (field_address.h)
  std::vector<Named<double>> measured;  // such as {"release", 12}: names say the unit
};

}  // namespace hazumi::edit
