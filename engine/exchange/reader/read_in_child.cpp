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

Result<Character> Run(const char* task, const std::string& path, const ReadOptions& options) {
  Result<ChildOutcome> outcome = RunReader({task, path, {}}, options);
  if (!outcome.ok())
    return outcome.error().file.empty() ? Of(path, outcome.error()) : outcome.error();
  if (const auto error = WhyNoAnswer(outcome.value(), options.limits)) return Of(path, *error);
  return CharacterFromBytes(outcome.value().output, path);
}

}  // namespace

Result<Character> ReadInChild(const std::string& path, const ReadOptions& options) {
  return Run(kReadCharacter, path, options);
}

Result<Character> ReadThingInChild(const std::string& path, const ReadOptions& options) {
  return Run(kReadThing, path, options);
}

}  // namespace hazumi
