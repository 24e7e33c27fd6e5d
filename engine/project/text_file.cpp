#include "engine/project/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "engine/project/checks.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

constexpr size_t kLargestFile = 64u << 20;
constexpr mode_t kPermissionBits = 07777;

Error Fail(const std::string& path, Check check,
           std::initializer_list<std::string_view> arguments = {}) {
  Error error = MakeError(check, "", arguments);
  error.file = path;
  return error;
}

// An open file descriptor, closed at the end of the scope.
class OpenFile {
 public:
  OpenFile(const std::string& path, int flags, mode_t mode = 0)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~OpenFile() { Close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }
  bool Close() {
    const int fd = std::exchange(fd_, -1);
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

std::optional<struct stat> StatusOf(const std::string& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

// Reads until the end, or one byte past the limit. False: errno says why.
bool ReadAll(int fd, std::string* text) {
  char buffer[1 << 16];
  while (text->size() <= kLargestFile) {
    const ssize_t count = ::read(fd, buffer, sizeof buffer);
    if (count == 0) return true;
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text->append(buffer, static_cast<size_t>(count));
  }
  return true;
}

bool WriteAll(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(fd, text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

// The file that a link leads to, so that saving does not replace the link.
std::string FollowLinks(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::canonical(path, failed);
  return failed ? path : target.string();
}

// Written text in a new file beside `target`, or errno.
bool WriteTemporary(const std::string& temporary, const std::string& target,
                    std::string_view text) {
  OpenFile file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (!file.is_open()) return false;
  const auto old = StatusOf(target);
  if (old && ::fchmod(file.fd(), old->st_mode & kPermissionBits) != 0) return false;
  return WriteAll(file.fd(), text) && ::fsync(file.fd()) == 0 && file.Close();
}

std::string FolderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// A name that no other process or thread uses at the same time.
std::string TemporaryName(const std::string& target, const void* unique) {
  const std::string suffix =
      std::to_string(::getpid()) + "-" + std::to_string(reinterpret_cast<uintptr_t>(unique));
  return FolderOf(target) + "/." + fs::path(target).filename().string() + "." + suffix + ".tmp";
}

// Makes the renaming itself last. The new file is in place, so a failure is not one of saving.
void SyncFolder(const std::string& folder) {
  OpenFile handle(folder, O_RDONLY | O_DIRECTORY);
  if (handle.is_open()) ::fsync(handle.fd());
}

}  // namespace

Result<std::string> ReadTextFile(const std::string& path) {
  const auto status = StatusOf(path);
  if (!status) return Fail(path, Check::kCannotRead, {std::strerror(errno)});
  // A device or pipe might never end.
  if (!S_ISREG(status->st_mode)) return Fail(path, Check::kNotAFile);
  OpenFile file(path, O_RDONLY);
  std::string text;
  if (!file.is_open() || !ReadAll(file.fd(), &text)) {
    return Fail(path, Check::kCannotRead, {std::strerror(errno)});
  }
  if (text.size() > kLargestFile) return Fail(path, Check::kFileTooBig);
  return text;
}

Result<Done> ReplaceTextFile(const std::string& path, std::string_view text) {
  const std::string target = FollowLinks(path);
  const auto old = StatusOf(target);
  if (old && !S_ISREG(old->st_mode)) {
    return Fail(path, Check::kCannotReplace, {"it is not a file"});
  }
  if (old && ::access(target.c_str(), W_OK) != 0) {
    return Fail(path, Check::kCannotReplace, {std::strerror(errno)});
  }
  const std::string temporary = TemporaryName(target, &text);
  if (!WriteTemporary(temporary, target, text) ||
      std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::remove(temporary.c_str());
    return Fail(path, Check::kCannotWrite, {std::strerror(reason)});
  }
  SyncFolder(FolderOf(target));
  return Done{};
}

}  // namespace hazumi
