#include "engine/base/atomic_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include "engine/base/input_files.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

constexpr mode_t kPermissionBits = 07777;

// An open file descriptor, closed at the end of the scope.
class OpenFile {
 public:
  OpenFile(const std::string& path, int flags, mode_t mode = 0)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~OpenFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }

 private:
  int fd_;
};

std::string FolderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// A process has its temporary file locked as long as it writes it, and the system lets go of the
// lock however the process ends: one without a lock is left of a process that was killed.
bool Lock(int fd) {
  // Where a file system knows no locks nothing is ever taken for left.
  return ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

std::string TemporaryName(const std::string& target, int number) {
  const std::string suffix = number == 0 ? ".tmp" : "." + std::to_string(number) + ".tmp";
  return FolderOf(target) + "/." + fs::path(target).filename().string() + suffix;
}

// False if it is not there, not one of ours, or in use.
bool RemoveIfLeft(const std::string& temporary) {
  const OpenFile file(temporary, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  struct stat status;
  return file.is_open() && ::fstat(file.fd(), &status) == 0 && S_ISREG(status.st_mode) &&
         status.st_uid == ::geteuid() && ::flock(file.fd(), LOCK_EX | LOCK_NB) == 0 &&
         IsFileAt(file.fd(), temporary) && ::unlink(temporary.c_str()) == 0;
}

// A new file beside the target, locked, that no one else writes.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) {
    constexpr int kMost = 1000;  // that write one file at a time
    int number = 0;
    while ((failure_ = TryToCreate(TemporaryName(target, number))) == EEXIST && number < kMost) {
      ++number;
    }
    while (failure_ == 0 && RemoveIfLeft(TemporaryName(target, ++number))) {
    }
  }

  int failure() const { return failure_; }  // 0, or errno
  const std::string& path() const { return path_; }
  int fd() const { return file_->fd(); }

 private:
  // 0, or errno: EEXIST where someone else writes one of this name.
  int TryToCreate(const std::string& path) {
    path_ = path;
    RemoveIfLeft(path);
    file_.emplace(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (!file_->is_open()) return errno;
    // It may have been taken for left before it was locked.
    return Lock(file_->fd()) && IsFileAt(file_->fd(), path) ? 0 : EEXIST;
  }

  std::string path_;
  std::optional<OpenFile> file_;
  int failure_;
};

// What the system put off until a file is closed, here while it stays open and locked.
bool FinishWriting(int fd) {
  const int second = ::dup(fd);
  return second >= 0 && ::close(second) == 0;
}

// False: errno says why.
bool Fill(const TemporaryFile& file, const std::string& target, std::string_view bytes,
          WriteMode mode) {
  struct stat old;
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  if (replaces && ::fchmod(file.fd(), old.st_mode & kPermissionBits) != 0) return false;
  return WriteAll(file.fd(), bytes) && (mode == WriteMode::kFast || ::fsync(file.fd()) == 0) &&
         FinishWriting(file.fd());
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

bool IsFileAt(int fd, const std::string& path) {
  struct stat own, there;
  return ::fstat(fd, &own) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         own.st_ino == there.st_ino && own.st_dev == there.st_dev;
}

void SyncFolderOf(const std::string& path) {
  OpenFile handle(FolderOf(path), O_RDONLY | O_DIRECTORY);
  if (handle.is_open()) ::fsync(handle.fd());
}

int ReplaceFile(const std::string& path, std::string_view bytes, WriteMode mode,
                const std::atomic<bool>* cancel) {
  const std::string target = FollowLinks(path);
  const TemporaryFile temporary(target);
  if (temporary.failure() != 0) return temporary.failure();
  if (!Fill(temporary, target, bytes, mode) || IsSet(cancel) ||
      std::rename(temporary.path().c_str(), target.c_str()) != 0) {
    const int reason = errno;
    std::remove(temporary.path().c_str());
    return reason;
  }
  if (mode == WriteMode::kDurable) SyncFolderOf(target);
  return 0;
}

Result<Done> WriteFileAtomically(const std::string& path, std::string_view bytes, WriteMode mode,
                                 const std::atomic<bool>* cancel, std::optional<InputKind> kind) {
  if (const auto kept = WhyKept(path, kind)) return *kept;
  const int reason = ReplaceFile(path, bytes, mode, cancel);
  if (reason == 0) return Done{};
  if (reason == ECANCELED) return Error{ErrorCode::kInterrupted, path, "", "is not written"};
  return Error{ErrorCode::kCannotWrite, path, "",
               std::string("cannot be written: ") + std::strerror(reason)};
}

}  // namespace hazumi
