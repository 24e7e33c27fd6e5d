#pragma once

// How the entries of the table put values where they belong. Each returns whether it is one.

#include <optional>
#include <string>

#include "app/cli/option_values.h"
#include "app/cli/options.h"

namespace hazumi {

template <typename Value, typename Field>
bool Keep(const std::optional<Value>& value, Field* field) {
  if (value) *field = *value;
  return value.has_value();
}

inline bool KeepInt(const std::string& text, int least, int most, int* field) {
  const auto number = ReadInt(text);
  return number && *number >= least && *number <= most && Keep(number, field);
}

template <bool Options::*kField, bool kValue = true>
bool Set(const std::string&, Options* options) {
  options->*kField = kValue;
  return true;
}

}  // namespace hazumi
