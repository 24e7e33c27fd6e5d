#pragma once

// Entries of a project's lists by their names.

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

// Error about an input that is not taken. `place`: the parameter that it is about, or empty.
inline Error Refusal(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

// Returns the entry of a list with this name. Errors: kSchema, with the names that there are.
template <typename T>
Result<T*> EntryNamed(const std::string& name, const char* what, std::vector<T>* list) {
  std::string known;
  for (T& entry : *list) {
    if (entry.name == name) return &entry;
    known += (known.empty() ? "\"" : ", \"") + entry.name + "\"";
  }
  return Refusal(
      what, "there is no \"" + name + "\"; there " + (known.empty() ? "are none" : "is " + known));
}

// Returns "box" of "box 2".
inline std::string WithoutNumber(const std::string& name) {
  const size_t digits = name.find_last_not_of("0123456789") + 1;
  const bool is_numbered = digits > 1 && digits < name.size() && name[digits - 1] == ' ';
  return is_numbered ? name.substr(0, digits - 1) : name;
}
// Returns the name, with the next number behind it if another entry of the list has the name.
template <typename T>
std::string FreeName(const std::string& wanted, const std::vector<T>& list,
                     const T* own = nullptr) {
  std::string name = wanted;
  const auto is_taken = [&](const T& entry) { return &entry != own && entry.name == name; };
  for (int i = 2; std::any_of(list.begin(), list.end(), is_taken); ++i) {
    name = WithoutNumber(wanted) + " " + std::to_string(i);
  }
  return name;
}

// Returns a free name of an object of the scene or a held one: constraints name both.
inline std::string FreeObjectName(const std::string& wanted, const Project& project) {
  std::vector<Named<bool>> objects;
  for (const auto& object : project.scene.objects) objects.push_back({object.name});
  for (const auto& object : project.held_objects) objects.push_back({object.name});
  return FreeName(wanted, objects);
}

}  // namespace hazumi
