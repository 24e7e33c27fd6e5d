#include "ui/edit/document/file_digest.h"

#include <cstdint>
#include <cstdio>

#include "engine/project/json/text_file.h"

namespace hazumi::edit {

std::string DigestOf(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string DigestOfFile(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  return text.ok() ? DigestOf(text.value()) : "";
}

}  // namespace hazumi::edit
