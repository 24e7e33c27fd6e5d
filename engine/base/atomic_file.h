#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/input_files.h"
#include "engine/base/result.h"

namespace hazumi {

// kDurable also waits until the bytes are on the disk: for what a person would miss.
enum class WriteMode { kFast, kDurable };

// Writes a file all or nothing: a temporary file in the same folder takes its name once it is
// whole. On failure the old file stays as it was and nothing is left behind; what a process that
// was killed left goes when the file is next written. An existing file keeps its permissions; a
// symbolic link is followed. Returns 0, or errno.
// Setting `cancel` before the file has its name leaves it without: ECANCELED.
int ReplaceFile(const std::string& path, std::string_view bytes, WriteMode mode,
                const std::atomic<bool>* cancel = nullptr);

// ReplaceFile with an Error (kCannotWrite, kInterrupted) that names file and reason. Refuses to
// replace an input file of this process, unless the input is of the given kind (WhyKept).
Result<Done> WriteFileAtomically(const std::string& path, std::string_view bytes,
                                 WriteMode mode = WriteMode::kFast,
                                 const std::atomic<bool>* cancel = nullptr,
                                 std::optional<InputKind> kind = std::nullopt);

// For files that are written otherwise. All bytes, however many calls that takes; false: errno.
bool WriteAll(int fd, std::string_view bytes);
// The path, if it is no link, leads to the file that is open.
bool IsFileAt(int fd, const std::string& path);
// Makes the name of a file last. The file is in place, so a failure is not one of writing.
void SyncFolderOf(const std::string& path);

}  // namespace hazumi
