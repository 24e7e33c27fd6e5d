#pragma once

// Internal.

#include <map>
#include <string>

#include "engine/project/json/site.h"

namespace hazumi {

// Names of one list: none twice.
template <typename Items>
void CheckNamesUnique(const Items& items, const Site& site) {
  std::map<std::string, size_t> places;
  for (size_t i = 0; i < items.size(); ++i) {
    const auto [it, fresh] = places.emplace(items[i].name, i);
    if (fresh) continue;
    site.Item(i).Field("name").Report(Check::kNameTwice,
                                      {Quoted(items[i].name), site.Item(it->second).place});
  }
}

}  // namespace hazumi
