#include "engine/exchange/reader/read_in_child.h"

#include "engine/exchange/character/character_bytes.h"

namespace hazumi {
namespace {

constexpr const char* kRemedy =
    "; the file is probably broken: export it again, or in another format";

Error Of(const std::string& file, Error error) {
  error.file = file;
  if (error.code == ErrorCode::kSyntax) error.message += kRemedy;
  return error;
}

}  // namespace

Result<Character> ReadInChild(ReadUse use, const std::string& path, const ReadOptions& options) {
  const char* task = use == ReadUse::kThing ? kReadThing : kReadCharacter;
  Result<ChildOutcome> outcome = RunReader({task, path, {}}, options);
  if (!outcome.ok())
    return outcome.error().file.empty() ? Of(path, outcome.error()) : outcome.error();
  if (const auto error = WhyNoAnswer(outcome.value(), options.limits)) return Of(path, *error);
  return CharacterFromBytes(outcome.value().output, path);
}

}  // namespace hazumi
