// Roles of nodes in a body, as avatars say them: VRM 0.x in extensions.VRM.humanoid.humanBones, a
// list of {"bone", "node"}; VRM 1.0 in extensions.VRMC_vrm.humanoid.humanBones, {NAME: {"node"}}.

#include <optional>

#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

struct VrmWord {
  std::string_view name;  // after left or right
  BodyRole role;
};

constexpr VrmWord kMiddle[] = {{"hips", BodyRole::kHips},   {"spine", BodyRole::kSpine},
                               {"chest", BodyRole::kSpine}, {"upperChest", BodyRole::kSpine},
                               {"neck", BodyRole::kNeck},   {"head", BodyRole::kHead}};
constexpr VrmWord kSides[] = {{"Shoulder", BodyRole::kClavicle}, {"UpperArm", BodyRole::kUpperArm},
                              {"LowerArm", BodyRole::kForearm},  {"Hand", BodyRole::kHand},
                              {"UpperLeg", BodyRole::kThigh},    {"LowerLeg", BodyRole::kShin},
                              {"Foot", BodyRole::kFoot},         {"Toes", BodyRole::kToe}};
constexpr std::string_view kFingers[] = {"Thumb", "Index", "Middle", "Ring", "Little"};

std::optional<BodyPlace> PlaceOf(std::string_view name) {
  for (const VrmWord& word : kMiddle) {
    if (name == word.name) return BodyPlace{word.role, BodySide::kMiddle};
  }
  BodySide side = BodySide::kMiddle;
  for (const BodySide one : {BodySide::kLeft, BodySide::kRight}) {
    const std::string_view text = NameOf(one);
    if (!name.starts_with(text)) continue;
    side = one;
    name.remove_prefix(text.size());
    break;
  }
  if (side == BodySide::kMiddle) return std::nullopt;
  for (const VrmWord& word : kSides) {
    if (name == word.name) return BodyPlace{word.role, side};
  }
  for (const std::string_view finger : kFingers) {
    if (name.starts_with(finger)) return BodyPlace{BodyRole::kFinger, side};
  }
  return std::nullopt;
}

}  // namespace

void AddVrmPlaces(const GltfDocument& document, const GltfNodes& nodes, Scene* scene) {
  const auto add = [&](const std::string& bone, const Json& node) {
    const int place = nodes.Find(node);
    if (place >= 0) scene->nodes[static_cast<size_t>(place)].place = PlaceOf(bone);
  };
  const Json& extensions = Member(document.json, "extensions");
  const auto bones_of = [&](const char* extension) -> const Json& {
    return Member(Member(Member(extensions, extension), "humanoid"), "humanBones");
  };
  const Json& old = bones_of("VRM");
  if (old.is_array()) {
    for (const Json& bone : old) add(Text(Member(bone, "bone")), Member(bone, "node"));
  }
  const Json& now = bones_of("VRMC_vrm");
  if (now.is_object()) {
    for (const auto& [name, bone] : now.items()) add(name, Member(bone, "node"));
  }
}

}  // namespace hazumi
