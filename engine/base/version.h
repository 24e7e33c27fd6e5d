#pragma once

// Which Hazumi this is. The version is the engine's; whoever asks for the commit links
// hazumi_commit, a library of its own, so that a new commit compiles one small file and links the
// programs, nothing else.

#include <string>

namespace hazumi {

// The version of the project: "0.1.0".
extern const char* const kVersion;

// The commit that was built, abbreviated, with "+" behind it if files of it were changed:
// "abc1234+". "unknown" if it was built without git and not from an archive that git made.
extern const char* const kCommit;

// Both: "0.1.0 (abc1234)".
std::string ProgramVersion();

}  // namespace hazumi
