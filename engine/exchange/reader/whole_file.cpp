#include "engine/exchange/reader/whole_file.h"

#include <errno.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace hazumi {
namespace {

Error CannotRead(const std::string& path, const std::string& why) {
  return {ErrorCode::kNoInput, path, "", "cannot be read: " + why};
}

}  // namespace

Result<std::string> FileBeginning(const std::string& path, size_t most) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return CannotRead(path, "there is no such file");
  // A pipe or a device might never end.
  if (!std::filesystem::is_regular_file(status)) return CannotRead(path, "it is not a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return CannotRead(path, std::strerror(errno));
  const uintmax_t size = std::filesystem::file_size(path, error);
  std::string bytes(error ? 0 : static_cast<size_t>(std::min<uintmax_t>(size, most)), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) return CannotRead(path, std::strerror(errno));
  bytes.resize(static_cast<size_t>(in.gcount()));
  return bytes;
}

Result<std::string> WholeFile(const std::string& path, size_t most) {
  Result<std::string> bytes = FileBeginning(path, most + 1);
  if (bytes.ok() && bytes.value().size() > most)
    return CannotRead(path, "it is longer than " + std::to_string(most >> 20) + " MB");
  return bytes;
}

}  // namespace hazumi
