#pragma once

// The JSON of a glTF or GLB file [glTF 2.0, 3 and 4].

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

struct GltfDocument {   // NOLINT(bugprone-exception-escape): null JSON does not throw
  nlohmann::json json;  // an object
  std::string binary;   // the BIN chunk of a GLB
};

// Error: not JSON, not version 2.
Result<GltfDocument> ParseGltf(std::string_view bytes, const std::string& file);

// Members and elements that may be missing or of another type: then null, `missing`, or empty.
const nlohmann::json& Member(const nlohmann::json& value, const std::string& key);
const nlohmann::json& Element(const nlohmann::json& list, const nlohmann::json& index);
size_t Count(const nlohmann::json& value, const std::string& key, size_t missing);
std::string Text(const nlohmann::json& value);
std::vector<double> Numbers(const nlohmann::json& value, size_t count);  // so many

}  // namespace hazumi
