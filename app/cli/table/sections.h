#pragma once

// The parts of the table of options (../option_table.h), a file for each section of the help: its
// entries in the order of the help.

#include <optional>
#include <span>
#include <string>

#include "app/cli/option_table.h"
#include "app/cli/option_values.h"
#include "app/cli/options.h"

namespace hazumi {

std::span<const OptionRule> TaskRules();
std::span<const OptionRule> DrawingRules();
std::span<const OptionRule> ForeignFileRules();
std::span<const OptionRule> MotionRules();
std::span<const OptionRule> OutputRules();
std::span<const OptionRule> SweepRules();
std::span<const OptionRule> EditorRules();

// Functions by which the entries put values where they belong. Each returns whether it is one.

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
