#pragma once

#include <atomic>
#include <string>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

// The .kfa text of a project: two-space indent, what fits on a line of 100 columns stays on it,
// shortest numbers that read back the same. Reading and writing it again gives the same bytes.
// Optional fields that have their default value are left out.
std::string WriteProject(const Project& project);

// The same, or why it could not be read back (kCannotWrite): it would be too large. `path` is named
// in errors.
Result<std::string> TextToSave(const Project& project, const std::string& path);

// Writes the file all or nothing: a failure leaves the old file as it was. An existing file keeps
// its permissions; a link is followed. Errors: kCannotWrite; kInterrupted where `cancel` is set
// before the file has its name.
Result<Done> SaveProject(const Project& project, const std::string& path,
                         const std::atomic<bool>* cancel = nullptr);

// Makes relative references, of figure, audio and reference picture, that are good in `from_folder`
// good in `to_folder`: for "save as".
void RebaseReferences(Project* project, const std::string& from_folder,
                      const std::string& to_folder);

}  // namespace hazumi
