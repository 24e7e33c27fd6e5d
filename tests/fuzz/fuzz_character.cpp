// Any bytes as the answer of the reader's process: a character, which says the same bytes again,
// or an error; one that is not too large is imported.

#include <cstdint>
#include <string_view>

#include "engine/exchange/character/character_bytes.h"
#include "tests/fuzz/imported.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto character = hazumi::CharacterFromBytes(bytes, "fuzz.fbx");
  if (!character.ok()) return 0;
  HAZUMI_DEMAND(hazumi::CharacterToBytes(character) == bytes);
  hazumi::fuzz::ImportIfSmall(character.value());
  return 0;
}
