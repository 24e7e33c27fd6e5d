#pragma once

// Lists of everything in a project that has an address (field_address.h): fields, items.

#include <string>
#include <utility>
#include <vector>

#include "engine/project/project.h"

namespace hazumi {

struct ListedField {
  std::string address;  // field_address.h
  std::string json;     // its value as it stands in a file; "null": left out
};

// All fields of a project that have an address, in the order of the file.
std::vector<ListedField> ListFields(const Project& project);

// An item of a project and its address: "regions[arms]", "placements[0]" (field_address.h).
struct ItemAddress {
  ItemId id;
  std::string address;
};

// Returns the addresses of all items that have an id, kind by kind.
std::vector<ItemAddress> ItemAddresses(const Project& project);

}  // namespace hazumi
