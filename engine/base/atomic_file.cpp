#include "engine/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace hazumi {

namespace {

namespace fs = std::filesystem;

constexpr mode_t kPermissionBits = 07777;

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

// The file that a link leads to, so that writing does not replace the link.
std::string FollowLinks(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::canonical(path, failed);
  return failed ? path : target.string();
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

// False: errno says why.
bool WriteTemporary(const std::string& temporary, const std::string& target, std::string_view bytes,
                    WriteMode mode) {
  OpenFile file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
  if (!file.is_open()) return false;
  struct stat old;
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  if (replaces && ::fchmod(file.fd(), old.st_mode & kPermissionBits) != 0) return false;
  const bool whole = WriteAll(file.fd(), bytes);
  return whole && (mode == WriteMode::kFast || ::fsync(file.fd()) == 0) && file.Close();
}

bool IsSet(const std::atomic<bool>* cancel) {
  if (!cancel || !*cancel) return false;
  errno = ECANCELED;
  return true;
}

}  // namespace

bool WriteAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

void SyncFolderOf(const std::string& path) {
  OpenFile handle(FolderOf(path), O_RDONLY | O_DIRECTORY);
  if (handle.is_open()) ::fsync(handle.fd());
}

int ReplaceFile(const std::string& path, std::string_view bytes, WriteMode mode,
                const std::atomic<bool>* cancel) {
  const std::string target = FollowLinks(path);
  const std::string temporary = TemporaryName(target, &bytes);
  if (!WriteTemporary(temporary, target, bytes, mode) || IsSet(cancel) ||
      std::rename(temporary.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::remove(temporary.c_str());
    return reason;
  }
  if (mode == WriteMode::kDurable) SyncFolderOf(target);
  return 0;
}

Result<Done> WriteFileAtomically(const std::string& path, std::string_view bytes, WriteMode mode,
                                 const std::atomic<bool>* cancel) {
  const int reason = ReplaceFile(path, bytes, mode, cancel);
  if (reason == 0) return Done{};
  if (reason == ECANCELED) return Error{ErrorCode::kInterrupted, path, "", "is not written"};
  return Error{ErrorCode::kCannotWrite, path, "",
               std::string("cannot be written: ") + std::strerror(reason)};
}

}  // namespace hazumi
