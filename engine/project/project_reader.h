#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

// Reads a .kfa file, and the figure file it names. The first thing wrong is reported with its
// place and a remedy: kNoInput (cannot be read), kSyntax (not JSON; the place is line and column),
// kSchema (JSON of the wrong shape, values out of range, unknown names).
Result<Project> LoadProject(const std::string& path);

// The same from text. `file_name` is named in errors; the figure's file is looked up in its folder.
Result<Project> ParseProject(std::string_view text, const std::string& file_name);

// The JSON schema (draft 7) of .kfa files, made of the descriptions of their fields.
std::string ProjectSchema();

}  // namespace hazumi
