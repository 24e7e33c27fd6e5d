#include "engine/base/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace hazumi {

namespace {

namespace fs = std::filesystem;

Error CannotWrite(const std::string& path, int error) {
  return {ErrorCode::kCannotWrite, path, "", std::string("cannot be written: ") + strerror(error)};
}

// A file that goes away again unless it is renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : name_(target + ".XXXXXX") {
    fd_ = mkstemp(name_.data());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (fd_ < 0) return;
    close(fd_);
    if (!renamed_) unlink(name_.c_str());
  }

  bool is_open() const { return fd_ >= 0; }

  bool Write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = write(fd_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes.remove_prefix(static_cast<size_t>(written));
    }
    return true;
  }

  bool TakePermissionsOf(const std::string& target) {
    struct stat info;
    if (stat(target.c_str(), &info) == 0) return fchmod(fd_, info.st_mode & 07777) == 0;
    const mode_t mask = umask(0);
    umask(mask);
    return fchmod(fd_, 0666 & ~mask) == 0;
  }

  bool Sync() { return fsync(fd_) == 0; }

  bool RenameTo(const std::string& target) {
    renamed_ = rename(name_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string name_;
  int fd_ = -1;
  bool renamed_ = false;
};

std::string WithoutLinks(const std::string& path) {
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved.string();
}

void SyncFolder(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  const int fd = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (fd < 0) return;
  fsync(fd);
  close(fd);
}

}  // namespace

Result<Done> WriteFileAtomically(const std::string& path, std::string_view bytes, WriteMode mode) {
  const std::string target = WithoutLinks(path);
  TemporaryFile file(target);
  const bool durable = mode == WriteMode::kDurable;
  if (!file.is_open() || !file.Write(bytes) || !file.TakePermissionsOf(target) ||
      (durable && !file.Sync()) || !file.RenameTo(target)) {
    return CannotWrite(path, errno);
  }
  if (durable) SyncFolder(target);
  return Done{};
}

Result<std::string> ReadWholeFile(const std::string& path, size_t max_bytes) {
  const auto no_input = [&path](const std::string& why) {
    return Error{ErrorCode::kNoInput, path, "", "cannot be read: " + why};
  };
  std::error_code error;
  if (fs::is_directory(path, error)) return no_input("it is a folder");
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return no_input(strerror(errno));
  std::string bytes;
  char buffer[65536];
  size_t got = 0;
  while ((got = std::fread(buffer, 1, sizeof buffer, file)) > 0 && bytes.size() <= max_bytes) {
    bytes.append(buffer, got);
  }
  const bool failed = std::ferror(file) != 0;
  const int reason = errno;
  std::fclose(file);
  if (failed) return no_input(strerror(reason));
  if (bytes.size() > max_bytes) {
    return no_input("larger than " + std::to_string(max_bytes) + " bytes");
  }
  return bytes;
}

}  // namespace hazumi
