#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// The bytes of a view that EXT_meshopt_compression keeps, decoded by libmeshoptimizer. `extension`
// is that of the view, `bytes` what it keeps. Error: bytes that cannot be decoded.
Result<std::string> DecodeMeshopt(const nlohmann::json& extension, std::string_view bytes,
                                  const std::string& place, const std::string& file);

}  // namespace hazumi
