#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/project/project.h"

namespace hazumi {

// An item of a project and its address: "regions[arms]", "placements[0]" (field_address.h).
struct ItemAddress {
  ItemId id;
  std::string address;
};

// Returns the addresses of all items that have an id, kind by kind.
std::vector<ItemAddress> ItemAddresses(const Project& project);

}  // namespace hazumi
