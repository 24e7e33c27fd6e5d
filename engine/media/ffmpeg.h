#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace hazumi {

// What is read, as messages call it.
struct MediaKind {
  const char* name;    // "sound"
  const char* remedy;  // of a file without one, or a damaged one
};

// Output of ffmpeg for a file, with these output options. ffmpeg opens this file alone, reads only
// formats that name no other files (no playlists, no text), writes nothing, and has limits of
// processor time, memory and output. Errors, with the file's name: kNoInput if it cannot be opened,
// kSyntax if ffmpeg finds nothing of the kind in it or it is damaged, kFailed without ffmpeg or if
// it is too long, kInterrupted if `is_cancelled`, which may be empty.
Result<std::string> RunFfmpeg(const std::filesystem::path& file,
                              const std::vector<std::string>& output, const MediaKind& kind,
                              const std::function<bool()>& is_cancelled);

}  // namespace hazumi
