#pragma once

// Internal. A file of one described struct (fields/project_fields.h), which has `read` for
// warnings.

#include <string>
#include <string_view>

#include "engine/project/checks/field_checker.h"
#include "engine/project/figure_fields.h"
#include "engine/project/json/json.h"
#include "engine/project/json/read_value.h"

namespace hazumi {

// Reads a file of version 1 of this format, checks every field, and then what several fields say
// together: check(value, errors). The first thing wrong is reported: kSyntax, kSchema, with the
// file's name.
template <typename T, typename CheckTogether>
Result<T> ParseDescribedFile(std::string_view text, const std::string& file_name,
                             const char* format, Check other_format, CheckTogether check) {
  FirstError errors;
  const std::optional<Json> json = ParseJson(text, &errors);
  if (!json) return errors.In(file_name);
  T value;
  const Site site{"", &errors, &value.read.warnings, &value.read.unknown};
  if (ExpectFormat(*json, format, 1, other_format, site)) ReadValue(*json, site, value);
  if (errors.ok()) {
    FieldChecker fields(&errors);
    Describe(fields, value);
    check(value, &errors);
  }
  if (!errors.ok()) return errors.In(file_name);
  return value;
}

}  // namespace hazumi
