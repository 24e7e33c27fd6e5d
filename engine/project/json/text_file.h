#pragma once

// Whole text files.

#include <atomic>
#include <string>
#include <string_view>

#include "engine/base/input_files.h"
#include "engine/base/result.h"

namespace hazumi {

inline constexpr size_t kLargestFile = 160u << 20;    // bytes that are read
inline constexpr size_t kMaxTreeBytes = 600'000'000;  // memory of a JSON tree

// The contents of a regular file of at most 160 MiB. Errors: kNoInput; kSchema if too big.
Result<std::string> ReadTextFile(const std::string& path);

// Replaces or creates the file all or nothing: a new file in the same folder takes its place once
// it is safely on the disk. Permissions are kept, a link is followed. Errors: kCannotWrite, also
// where the file is an input of another kind (WhyKept); kInterrupted where `cancel` is set before
// that.
Result<Done> ReplaceTextFile(const std::string& path, std::string_view text, InputKind kind,
                             const std::atomic<bool>* cancel = nullptr);

}  // namespace hazumi
