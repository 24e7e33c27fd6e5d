#pragma once

#include <string>

#include "engine/project/project.h"

namespace hazumi {

// Paths of the files that a project names; empty: the project names none. `project_path` is the
// project's own file; empty: it has none yet.
std::string FigurePath(const Project& project, const std::string& project_path);
std::string SoundPath(const Project& project, const std::string& project_path);
std::string ReferencePath(const Project& project, const std::string& project_path);

// Protects these files and the project's own file from being overwritten (KeepInput).
void KeepFilesOf(const Project& project, const std::string& project_path);

// Returns the name under which a project is shown: its own or, if it has none, that of its file
// without the suffix. A new project is called "Untitled".
std::string ShownName(const std::string& name, const std::string& file);

}  // namespace hazumi
