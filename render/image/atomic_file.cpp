#include "render/image/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>

namespace hazumi::render {
namespace {

namespace fs = std::filesystem;

Error CannotWrite(const fs::path& path, int reason) {
  return {ErrorCode::kCannotWrite, path.string(), "",
          std::string("cannot be written: ") + std::strerror(reason)};
}

// In the same folder, so that the rename stays within one file system.
fs::path TemporaryFor(const fs::path& path) {
  std::ostringstream name;
  name << '.' << path.filename().string() << '.' << getpid() << ".tmp";
  return path.parent_path() / name.str();
}

// 0, or errno.
int WriteAll(int file, const std::vector<std::uint8_t>& bytes) {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = write(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    done += static_cast<size_t>(count);
  }
  return 0;
}

// 0, or errno.
int WriteTemporary(const fs::path& path, const std::vector<std::uint8_t>& bytes) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  const int write_error = WriteAll(file, bytes);
  const int close_error = close(file) == 0 ? 0 : errno;
  return write_error != 0 ? write_error : close_error;
}

}  // namespace

Result<Done> WriteFileAtomically(const fs::path& path, const std::vector<std::uint8_t>& bytes) {
  const fs::path temporary = TemporaryFor(path);
  int reason = WriteTemporary(temporary, bytes);
  if (reason == 0 && std::rename(temporary.c_str(), path.c_str()) == 0) return Done{};
  if (reason == 0) reason = errno;
  unlink(temporary.c_str());
  return CannotWrite(path, reason);
}

}  // namespace hazumi::render
