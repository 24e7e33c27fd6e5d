// Any text as a BVH file: a character or an error; one that is not too large is imported.

#include <cstdint>
#include <string_view>

#include "engine/exchange/bvh/bvh_file.h"
#include "tests/fuzz/imported.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const hazumi::Result<hazumi::Character> character = hazumi::ReadBvh(text, "fuzz.bvh");
  if (character.ok()) hazumi::fuzz::ImportIfSmall(character.value());
  return 0;
}
