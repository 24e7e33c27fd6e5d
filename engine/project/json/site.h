#pragma once

// Internal.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/warning.h"
#include "engine/project/checks/checks.h"

namespace hazumi {

// Where a value stands and whom to tell.
struct Site {
  std::string place;
  FirstError* errors;
  std::vector<Warning>* warnings = nullptr;  // null: nobody wants to hear them
  std::vector<Warning>* unknown = nullptr;   // unknown fields; null: not collected

  void Report(Check check, std::initializer_list<std::string_view> arguments = {}) const {
    errors->Report(check, place, arguments);
  }
  void Warn(Check check, std::initializer_list<std::string_view> arguments) const {
    if (warnings) warnings->push_back({place, MessageOf(check, arguments)});
  }
  Site Field(const std::string& name) const {
    return {place.empty() ? name : place + "." + name, errors, warnings, unknown};
  }
  Site Item(size_t index) const {
    return {place + "[" + std::to_string(index) + "]", errors, warnings, unknown};
  }
};

}  // namespace hazumi
