#pragma once

// A glTF file of the text form, taken apart again.

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/base64.h"

namespace hazumi::test {

using Json = nlohmann::json;

struct Gltf {
  Json json;
  std::string buffer;

  std::vector<float> Floats(const Json& accessor_number) const {
    const Json& accessor = json["accessors"][accessor_number.get<size_t>()];
    EXPECT_EQ(accessor["componentType"], 5126);
    const std::map<std::string, size_t> widths = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    std::vector<float> values(accessor["count"].get<size_t>() * widths.at(accessor["type"]));
    const Json& view = json["bufferViews"][accessor["bufferView"].get<size_t>()];
    std::memcpy(values.data(), buffer.data() + view["byteOffset"].get<size_t>(),
                values.size() * sizeof(float));
    return values;
  }
  // None: the node has no such channel.
  const Json* Channel(const std::string& node, const std::string& path) const {
    for (const Json& channel : json["animations"][0]["channels"]) {
      const Json& target = channel["target"];
      if (json["nodes"][target["node"].get<size_t>()]["name"] == node && target["path"] == path)
        return &json["animations"][0]["samplers"][channel["sampler"].get<size_t>()];
    }
    return nullptr;
  }
};

inline Gltf TakenApart(const std::string& text) {
  Gltf gltf;
  gltf.json = Json::parse(text);
  const std::string uri = gltf.json["buffers"][0]["uri"];
  gltf.buffer = *FromBase64(uri.substr(uri.find(',') + 1));
  EXPECT_EQ(gltf.buffer.size(), gltf.json["buffers"][0]["byteLength"]);
  return gltf;
}

}  // namespace hazumi::test
