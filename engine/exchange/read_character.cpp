#include "engine/exchange/read_character.h"

#include "engine/exchange/content.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

namespace {

// What can be said without a child is said at once.
template <typename FindFormat>
std::optional<Error> WhyNot(const std::string& path, FindFormat find_format) {
  const Result<std::string> beginning = FileBeginning(path, kContentBytes);
  if (!beginning.ok()) return beginning.error();
  const Result<CharacterFormat> format = find_format(beginning.value(), path);
  if (!format.ok()) return format.error();
  return std::nullopt;
}

}  // namespace

Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options) {
  if (const auto error = WhyNot(path, FormatOf)) return *error;
  return ReadInChild(path, options);
}

Result<Character> ReadThing(const std::string& path, const ReadOptions& options) {
  if (const auto error = WhyNot(path, MeshFormatOf)) return *error;
  return ReadThingInChild(path, options);
}

}  // namespace hazumi
