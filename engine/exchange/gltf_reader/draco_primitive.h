#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/exchange/gltf_reader/accessors.h"

namespace hazumi {

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
