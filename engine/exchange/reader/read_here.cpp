#include "engine/exchange/reader/read_here.h"

#include "engine/exchange/assimp/scene_read.h"
#include "engine/exchange/bvh/bvh_read.h"
#include "engine/exchange/character/character_check.h"
#include "engine/exchange/content.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {
namespace {

Result<Character> ReadAs(CharacterFormat format, std::string bytes, const std::string& path) {
  if (format == CharacterFormat::kBvh) return ReadBvh(bytes, path);
  return ReadScene(format, SceneUse::kCharacter, std::move(bytes), path);
}

Result<Character> ReadThingAs(CharacterFormat format, std::string bytes, const std::string& path) {
  return ReadScene(format, SceneUse::kThing, std::move(bytes), path);
}

template <typename FindFormat, typename Read>
Result<Character> ReadFile(const std::string& path, FindFormat find_format, Read read) {
  Result<std::string> bytes = WholeFile(path, kLongestFile);
  if (!bytes.ok()) return bytes.error();
  const Result<CharacterFormat> format = find_format(bytes.value(), path);
  if (!format.ok()) return format.error();
  Result<Character> character = read(format.value(), std::move(bytes).value(), path);
  if (!character.ok()) return character;
  if (Result<Done> checked = CheckCharacter(character.value(), path); !checked.ok())
    return checked.error();
  return character;
}

}  // namespace

Result<Character> ReadHere(const std::string& path) { return ReadFile(path, FormatOf, ReadAs); }

Result<Character> ReadThingHere(const std::string& path) {
  return ReadFile(path, MeshFormatOf, ReadThingAs);
}

}  // namespace hazumi
