#pragma once

#include <optional>
#include <string>

#include "engine/media/sound_part.h"
#include "engine/project/project.h"

namespace hazumi::edit {

// Where a project's sound and its reference picture lie; `project_path` is empty of a project that
// has no file yet. Empty: the project has none.
std::string SoundPath(const Project& project, const std::string& project_path);
std::string ReferencePath(const Project& project, const std::string& project_path);

// The reference, if it is seen in rendered pictures.
std::optional<ProjectReference> RenderedReference(const Project& project);

// What is heard for `length_s` from `first_s` on [s since frame 0]; nothing if there is no sound or
// it is mute.
std::optional<SoundPart> HeardIn(const Project& project, const std::string& project_path,
                                 double first_s, double length_s);

}  // namespace hazumi::edit
