#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi::edit {

// A file that belongs to whoever has it open here, by flock: the system lets go of it when the
// process ends, however it ends.
class LockedFile {
 public:
  // Writes a file whole or not at all, for its owner's eyes only, and locked before it has its
  // name. One that has the name gives way. Returns when the bytes are on the disk. Error:
  // kCannotWrite.
  static Result<LockedFile> Create(const std::string& path, std::string_view bytes);
  // Opens a file that no one else has. Errors: kFailed (someone has it), kNoInput.
  static Result<LockedFile> Open(const std::string& path);

  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&& other) noexcept;
  ~LockedFile();

  const std::string& path() const { return path_; }
  // It is still what the path leads to.
  bool is_in_place() const;
  Result<std::string> Read() const;
  // Returns when the bytes are on the disk. On failure the file is as it was. Error: kCannotWrite.
  Result<Done> Append(std::string_view bytes);
  Result<Done> Remove();

 private:
  LockedFile(std::string path, int fd) : path_(std::move(path)), fd_(fd) {}
  Error CannotWrite() const;

  std::string path_;
  int fd_ = -1;
};

}  // namespace hazumi::edit
