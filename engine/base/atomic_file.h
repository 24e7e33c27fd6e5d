#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// kDurable also waits until the bytes are on the disk: for what a person would miss.
enum class WriteMode { kFast, kDurable };

// Writes the file all or nothing: to a temporary file in the same folder, which then takes the
// file's name. On failure the old file stays as it was and nothing is left behind. An existing file
// keeps its permissions; a symbolic link is followed. Error: kCannotWrite, naming file and reason.
Result<Done> WriteFileAtomically(const std::string& path, std::string_view bytes,
                                 WriteMode mode = WriteMode::kFast);

// The whole file, or kNoInput naming file and reason. Larger than `max_bytes` is an error too.
Result<std::string> ReadWholeFile(const std::string& path, size_t max_bytes);

}  // namespace hazumi
