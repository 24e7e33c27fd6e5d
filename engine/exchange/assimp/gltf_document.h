#pragma once

// The JSON of a glTF or GLB file, for what assimp 5.2.5 does not pass on or gets wrong.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/exchange/assimp/scene_clips.h"

namespace hazumi {

struct GltfDocument {   // NOLINT(bugprone-exception-escape): null JSON does not throw
  nlohmann::json json;  // an object
  std::string binary;   // the BIN chunk of a GLB
  bool is_glb = false;
};

// Error: not JSON, not version 2.
Result<GltfDocument> ParseGltf(std::string_view bytes, const std::string& file);
std::string GltfBytes(const GltfDocument& document);

// Members and elements that may be missing or of another type: then null.
const nlohmann::json& Member(const nlohmann::json& value, const std::string& key);
const nlohmann::json& Element(const nlohmann::json& list, const nlohmann::json& index);
// A member that is a number, 0 or more; otherwise `missing`.
size_t Count(const nlohmann::json& value, const std::string& key, size_t missing);

// How channels are interpolated; nodes must have names.
struct GltfNotes {
  SteppedChannels stepped;  // STEP
  int num_splines = 0;      // CUBICSPLINE
  // What Hazumi wrote of them into a file that no other program has written since, by node.
  std::map<std::string, BoneBody> bodies;
  std::vector<std::string> damaged;  // nodes of which that cannot be read
};
GltfNotes NotesOf(const GltfDocument& document);

}  // namespace hazumi
