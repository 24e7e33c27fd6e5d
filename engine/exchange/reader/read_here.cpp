#include "engine/exchange/reader/read_here.h"

#include "engine/exchange/assimp/scene_read.h"
#include "engine/exchange/bvh/bvh_read.h"
#include "engine/exchange/character/character_check.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

Result<Character> ReadHere(ReadUse use, const std::string& path) {
  Result<std::string> bytes = WholeFile(path, kLongestFile);
  if (!bytes.ok()) return bytes.error();
  const Result<CharacterFormat> format = FormatOf(use, bytes.value(), path);
  if (!format.ok()) return format.error();
  Result<Character> character =
      format.value() == CharacterFormat::kBvh
          ? ReadBvh(bytes.value(), path)
          : ReadScene(format.value(), use, std::move(bytes).value(), path);
  if (!character.ok()) return character;
  if (Result<Done> checked = CheckCharacter(character.value(), path); !checked.ok())
    return checked.error();
  return character;
}

}  // namespace hazumi
