#include "engine/project/json/text_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "engine/base/atomic_file.h"
#include "engine/project/checks/checks.h"

namespace hazumi {

namespace {

Error Fail(const std::string& path, Check check,
           std::initializer_list<std::string_view> arguments = {}) {
  Error error = MakeError(check, "", arguments);
  error.file = path;
  return error;
}

std::optional<struct stat> StatusOf(const std::string& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

}  // namespace

Result<std::string> ReadTextFile(const std::string& path) {
  const auto status = StatusOf(path);
  if (!status) return Fail(path, Check::kCannotRead, {std::strerror(errno)});
  // A device or pipe might never end.
  if (!S_ISREG(status->st_mode)) return Fail(path, Check::kNotAFile);
  const auto size = static_cast<size_t>(status->st_size);
  if (size > kLargestFile) return Fail(path, Check::kFileTooBig);
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (!file || !file.read(text.data(), status->st_size)) {
    return Fail(path, Check::kCannotRead, {std::strerror(errno)});
  }
  return text;
}

Result<Done> ReplaceTextFile(const std::string& path, std::string_view text, InputKind kind,
                             const std::atomic<bool>* cancel) {
  if (const auto kept = WhyKept(path, kind)) return *kept;
  const auto old = StatusOf(path);
  if (old && !S_ISREG(old->st_mode)) {
    return Fail(path, Check::kCannotReplace, {"it is not a file"});
  }
  if (old && ::access(path.c_str(), W_OK) != 0) {
    return Fail(path, Check::kCannotReplace, {std::strerror(errno)});
  }
  const int reason = ReplaceFile(path, text, WriteMode::kDurable, cancel);
  if (reason == ECANCELED) return Error{ErrorCode::kInterrupted, path, "", "is not written"};
  if (reason != 0) return Fail(path, Check::kCannotWrite, {std::strerror(reason)});
  return Done{};
}

}  // namespace hazumi
