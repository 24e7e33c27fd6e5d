#pragma once

// Internal. JSON text to a tree and back, without exceptions and safe against hostile text.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/project/checks/checks.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

using Json = nlohmann::ordered_json;

// Limits beyond which no project goes.
inline constexpr size_t kMaxJsonDepth = 64;

// Memory that a value takes in a tree, without what it contains, and a field's name, about [bytes].
size_t TreeBytes(const Json& value);
size_t NameBytes(std::string_view name);

// The tree, or nothing after reporting. The place of a syntax error is "line 3, column 5".
std::optional<Json> ParseJson(std::string_view text, FirstError* errors,
                              size_t most_bytes = kMaxTreeBytes);

// Pretty: two-space indent, an object or array stays on one line if it fits 100 columns.
std::string FormatJson(const Json& json);
// On one line.
std::string CompactJson(const Json& json);

}  // namespace hazumi
