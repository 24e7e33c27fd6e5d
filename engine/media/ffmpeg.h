#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

// Arguments of ffmpeg: a file to be read, which cannot make it open anything else.
std::vector<std::string> MediaInput(const std::filesystem::path& file);

// What is read, as messages call it.
struct MediaKind {
  const char* name;    // "sound"
  const char* remedy;  // of a file without one, or a damaged one
};

// What ffmpeg makes of a file with these options of its output. Errors, with the file's name:
// kNoInput if it cannot be opened, kSyntax if ffmpeg finds nothing of the kind in it or it is
// damaged, kFailed without ffmpeg or if it is too long, kInterrupted if `is_cancelled`, which may
// be empty.
Result<std::string> RunFfmpeg(const std::filesystem::path& file,
                              const std::vector<std::string>& output, const MediaKind& kind,
                              const std::function<bool()>& is_cancelled);

}  // namespace hazumi
