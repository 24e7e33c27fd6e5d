#pragma once

// Internal. Decoders of compressed data: views by libmeshoptimizer, primitives by libdraco.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/gltf_reader/accessors.h"

namespace hazumi {

// The bytes of a view that EXT_meshopt_compression keeps, decoded by libmeshoptimizer. `extension`
// is that of the view, `bytes` what it keeps. Error: bytes that cannot be decoded.
Result<std::string> DecodeMeshopt(const nlohmann::json& extension, std::string_view bytes,
                                  const std::string& place, const std::string& file);

// A primitive that KHR_draco_mesh_compression keeps, decoded by libdraco.
struct DracoPrimitive {
  std::map<std::string, GltfValues> attributes;  // by name, such as POSITION
  std::vector<uint32_t> indices;                 // three a triangle
};

// `extension` is that of the primitive, `bytes` those of its view. Error: bytes that are none of
// Draco, attributes that they do not have.
Result<DracoPrimitive> DecodeDraco(const nlohmann::json& extension, std::string_view bytes,
                                   const std::string& place, const std::string& file);

}  // namespace hazumi
