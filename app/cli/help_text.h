#pragma once

// Help and manual page, from the table of options, and what both say besides the table.

#include <span>
#include <string>

#include "app/cli/exit_codes.h"

namespace hazumi {

// Text that `hazumi --help` prints, at most 80 columns wide.
std::string HelpText();

// The manual page hazumi(1), in the macros of man(7).
std::string ManPage();

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
