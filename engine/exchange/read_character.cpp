#include "engine/exchange/read_character.h"

#include <filesystem>

#include "engine/base/utf8.h"
#include "engine/exchange/character/character_bytes.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

namespace {

constexpr const char* kRemedy =
    "; the file is probably broken: export it again, or in another format";

Error Of(const std::string& file, Error error) {
  error.file = file;
  if (error.code == ErrorCode::kSyntax) error.message += kRemedy;
  return error;
}

Result<Character> Read(ReadUse use, const std::string& path, const ReadOptions& options) {
  // What can be said without a child is said at once.
  const Result<std::string> beginning = FileBeginning(path, kContentBytes);
  if (!beginning.ok()) return beginning.error();
  const Result<CharacterFormat> format = FormatOf(use, beginning.value(), path);
  if (!format.ok()) return format.error();
  return ReadInChild(use, path, options);
}

}  // namespace

Result<Character> ReadInChild(ReadUse use, const std::string& path, const ReadOptions& options) {
  const char* task = use == ReadUse::kThing ? kReadThing : kReadCharacter;
  Result<ChildOutcome> outcome = RunReader({task, path, {}}, options);
  if (!outcome.ok())
    return outcome.error().file.empty() ? Of(path, outcome.error()) : outcome.error();
  if (const auto error = WhyNoAnswer(outcome.value(), options.limits)) return Of(path, *error);
  Result<Character> character = CharacterFromBytes(outcome.value().output, path);
  if (character.ok())
    character.value().file = ValidUtf8(std::filesystem::path(path).filename().string());
  return character;
}

Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options) {
  return Read(ReadUse::kCharacter, path, options);
}

Result<Character> ReadThing(const std::string& path, const ReadOptions& options) {
  return Read(ReadUse::kThing, path, options);
}

}  // namespace hazumi
