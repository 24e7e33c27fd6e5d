#pragma once

// Places of files, links followed, and input files, which are kept from being written over.

#include <optional>
#include <string>

#include "engine/base/result.h"

namespace hazumi {

// Canonical path: absolute, links followed as far as the path exists.
std::string FollowLinks(const std::string& path);

// True if the file lies in the folder or below it, links followed. False if either does not exist.
bool LiesIn(const std::string& file, const std::string& folder);

// Role of an input file.
enum class InputKind { kProject, kFigure, kSound, kReference, kPoses, kSweep, kScript };

// Protects an input file of this process from being replaced, links followed, until the process
// ends. Thread-safe.
void KeepInput(const std::string& path, InputKind kind);

// Error (kCannotWrite) if the file is protected as an input of another kind than `own`. An input of
// kind `own` may be replaced: a project is saved over a project.
std::optional<Error> WhyKept(const std::string& path, std::optional<InputKind> own = std::nullopt);

}  // namespace hazumi
