#pragma once

#include <algorithm>
#include <string>

namespace hazumi {

// The item of a list with this name, or null.
template <typename Items>
auto FindNamed(Items& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}

template <typename Items>
bool HasNamed(const Items& items, const std::string& name) {
  return FindNamed(items, name) != nullptr;
}

}  // namespace hazumi
