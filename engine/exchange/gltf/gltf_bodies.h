#pragma once

// What glTF cannot say of a bone, in `extras.hazumi` of its node: what hangs on it.

#include <nlohmann/json.hpp>
#include <optional>

#include "engine/exchange/character/character.h"

namespace hazumi {

nlohmann::ordered_json GltfBody(const BoneBody& body);
// None if it is not as GltfBody writes it.
std::optional<BoneBody> BodyFromGltf(const nlohmann::json& written);

}  // namespace hazumi
