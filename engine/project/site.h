#pragma once

// Internal.

#include <initializer_list>
#include <string>
#include <string_view>

#include "engine/project/checks.h"

namespace hazumi {

// Where a value stands and whom to tell.
struct Site {
  std::string place;
  FirstError* errors;

  void Report(Check check, std::initializer_list<std::string_view> arguments = {}) const {
    errors->Report(check, place, arguments);
  }
  Site Field(const std::string& name) const {
    return {place.empty() ? name : place + "." + name, errors};
  }
  Site Item(size_t index) const { return {place + "[" + std::to_string(index) + "]", errors}; }
};

}  // namespace hazumi
