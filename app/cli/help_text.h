#pragma once

// What `hazumi --help` prints, from the table of options; at most 80 columns wide. And what help
// and manual page say besides the table.

#include <span>
#include <string>

#include "app/cli/exit_codes.h"

namespace hazumi {

std::string HelpText();

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};
std::span<const ExitMeaning> ExitMeanings();

struct CallExample {
  const char* call;    // without the word hazumi
  const char* remark;  // may be empty
};
std::span<const CallExample> CallExamples();

inline constexpr const char* kSummary =
    "keyframe animation with regions that swing by their own inertia";
inline constexpr const char* kWhatFilesAre =
    "FILE is a project (.kfa); --render, --bake, --export, --check, --info and --flight read BVH, "
    "FBX, "
    "glTF, GLB and Collada as well.";
inline constexpr const char* kStreams =
    "Results go to standard output, progress and complaints to standard error.";

}  // namespace hazumi
