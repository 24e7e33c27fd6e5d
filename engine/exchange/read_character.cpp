#include "engine/exchange/read_character.h"

#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

namespace {

Result<Character> Read(ReadUse use, const std::string& path, const ReadOptions& options) {
  // What can be said without a child is said at once.
  const Result<std::string> beginning = FileBeginning(path, kContentBytes);
  if (!beginning.ok()) return beginning.error();
  const Result<CharacterFormat> format = FormatOf(use, beginning.value(), path);
  if (!format.ok()) return format.error();
  return ReadInChild(use, path, options);
}

}  // namespace

Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options) {
  return Read(ReadUse::kCharacter, path, options);
}

Result<Character> ReadThing(const std::string& path, const ReadOptions& options) {
  return Read(ReadUse::kThing, path, options);
}

}  // namespace hazumi
