#pragma once

#include <string>
#include <vector>

#include "engine/project/project.h"

namespace hazumi {

struct ListedField {
  std::string address;  // field_address.h
  std::string json;     // its value as it stands in a file; "null": left out
};

// All fields of a project that have an address, in the order of the file.
std::vector<ListedField> ListFields(const Project& project);

}  // namespace hazumi
