#include "engine/exchange/read_character.h"

#include "engine/exchange/content.h"
#include "engine/exchange/reader/whole_file.h"

namespace hazumi {

Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options) {
  // What can be said without a child is said at once.
  const Result<std::string> beginning = FileBeginning(path, kContentBytes);
  if (!beginning.ok()) return beginning.error();
  const Result<CharacterFormat> format = FormatOf(beginning.value(), path);
  if (!format.ok()) return format.error();
  return ReadInChild(path, options);
}

}  // namespace hazumi
