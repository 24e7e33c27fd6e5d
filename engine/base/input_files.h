#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"

namespace hazumi {

// Role of an input file.
enum class InputKind { kProject, kFigure, kSound, kReference, kPoses, kSweep, kScript };

// Protects an input file of this process from being replaced, links followed, until the process
// ends. Thread-safe.
void KeepInput(const std::string& path, InputKind kind);

// Error (kCannotWrite) if the file is protected as an input of another kind than `own`. An input of
// kind `own` may be replaced: a project is saved over a project.
std::optional<Error> WhyKept(const std::string& path, std::optional<InputKind> own = std::nullopt);

}  // namespace hazumi
