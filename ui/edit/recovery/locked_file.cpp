#include "ui/edit/recovery/locked_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "engine/base/atomic_file.h"

namespace hazumi::edit {

namespace {

Error NoInput(const std::string& path) {
  return {ErrorCode::kNoInput, path, "", std::string("cannot be read: ") + std::strerror(errno)};
}

}  // namespace

LockedFile::LockedFile(LockedFile&& other) noexcept
    : path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1)) {}

LockedFile& LockedFile::operator=(LockedFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  return *this;
}

LockedFile::~LockedFile() {
  if (fd_ >= 0) ::close(fd_);
}

Error LockedFile::CannotWrite() const {
  return {ErrorCode::kCannotWrite, path_, "",
          std::string("cannot be written: ") + std::strerror(errno)};
}

// What is left of a crash under the temporary name has no lock; it is written over.
Result<LockedFile> LockedFile::Create(const std::string& path, std::string_view bytes) {
  const std::string temporary = path + ".new";
  const int fd = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  LockedFile file(path, fd);
  if (fd < 0) return file.CannotWrite();
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0) return file.CannotWrite();
  if (::ftruncate(fd, 0) == 0 && WriteAll(fd, bytes) && ::fsync(fd) == 0 &&
      std::rename(temporary.c_str(), path.c_str()) == 0) {
    SyncFolderOf(path);
    return file;
  }
  Error error = file.CannotWrite();
  std::remove(temporary.c_str());
  return error;
}

Result<LockedFile> LockedFile::Open(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_APPEND | O_NONBLOCK | O_CLOEXEC);
  LockedFile file(path, fd);
  struct stat status;
  if (fd < 0 || ::fstat(fd, &status) != 0) return NoInput(path);
  if (!S_ISREG(status.st_mode)) return Error{ErrorCode::kNoInput, path, "", "is not a file"};
  // It may have been replaced or removed before it was locked.
  if (::flock(fd, LOCK_EX | LOCK_NB) != 0 || !file.is_in_place()) {
    return Error{ErrorCode::kFailed, path, "", "is in use by another Hazumi that is running"};
  }
  return file;
}

bool LockedFile::is_in_place() const { return IsFileAt(fd_, path_); }

Result<std::string> LockedFile::Read() const {
  std::string text;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count =
        ::pread(fd_, buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
    if (count < 0 && errno != EINTR) return NoInput(path_);
    if (count == 0) return text;
    if (count > 0) text.append(buffer.data(), static_cast<size_t>(count));
  }
}

Result<Done> LockedFile::Append(std::string_view bytes) {
  struct stat before;
  if (::fstat(fd_, &before) != 0) return CannotWrite();
  if (WriteAll(fd_, bytes) && ::fsync(fd_) == 0) return Done();
  Error error = CannotWrite();
  if (::ftruncate(fd_, before.st_size) != 0) error.message += "; its last line may be damaged";
  return error;
}

Result<Done> LockedFile::Remove() {
  if (!is_in_place() || ::unlink(path_.c_str()) == 0) return Done();
  return Error{ErrorCode::kCannotWrite, path_, "",
               std::string("cannot be removed: ") + std::strerror(errno)};
}

}  // namespace hazumi::edit
