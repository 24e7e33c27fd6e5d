#include "engine/exchange/import/role_map.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "engine/exchange/import/import_names.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "hazumi-roles";
constexpr size_t kLongestMap = 1u << 20;  // [bytes]

std::optional<BodyRole> RoleNamed(const std::string& name) {
  for (int i = 0; i < kNumBodyRoles; ++i) {
    if (name == NameOf(static_cast<BodyRole>(i))) return static_cast<BodyRole>(i);
  }
  return std::nullopt;
}

std::optional<BodyPlace> PlaceOf(std::string text) {
  BodyPlace place;
  for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
    const std::string word = std::string(NameOf(side)) + " ";
    if (!text.starts_with(word)) continue;
    place.side = side;
    text.erase(0, word.size());
  }
  const std::optional<BodyRole> role = RoleNamed(text);
  if (!role) return std::nullopt;
  place.role = *role;
  return place;
}

std::string AllRoles() {
  std::string names;
  for (int i = 0; i < kNumBodyRoles; ++i)
    names += std::string(i > 0 ? ", " : "") + NameOf(static_cast<BodyRole>(i));
  return names;
}

}  // namespace

std::string TextOfPlace(BodyPlace place) {
  const std::string side =
      place.side == BodySide::kMiddle ? "" : std::string(NameOf(place.side)) + " ";
  return side + NameOf(place.role);
}

Result<RoleMap> RolesFromText(const std::string& text, const std::string& file) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || json.value("format", Json()) != kFormat) {
    return Error{ErrorCode::kSyntax, file, "",
                 std::string("is no map of roles; it begins with {\"format\": \"") + kFormat +
                     "\", \"roles\": {\"BONE\": \"left upper_arm\"}}"};
  }
  const Json roles = json.value("roles", Json());
  if (!roles.is_object())
    return Error{ErrorCode::kSchema, file, "roles", "is missing: bones and their roles"};
  RoleMap map;
  for (const auto& [bone, value] : roles.items()) {
    const std::optional<BodyPlace> place =
        value.is_string() ? PlaceOf(value.get<std::string>()) : std::nullopt;
    if (!place) {
      return Error{ErrorCode::kSchema, file, "roles." + bone,
                   "must be one of " + AllRoles() +
                       ", with left or right before it where there "
                       "are two, as \"left upper_arm\""};
    }
    map[bone] = *place;
  }
  return map;
}

Result<RoleMap> ReadRoles(const std::string& path) {
  const Result<std::string> text = WholeFile(path, kLongestMap);
  if (!text.ok()) return text.error();
  return RolesFromText(text.value(), path);
}

}  // namespace hazumi
