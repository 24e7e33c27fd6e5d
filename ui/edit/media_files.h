#pragma once

#include <optional>
#include <set>
#include <string>

#include "engine/base/result.h"
#include "engine/media/sound_part.h"
#include "engine/project/project.h"

namespace hazumi::edit {

// Permission to open the sounds and references that projects name. A project may come from a
// stranger and name any file. Files in the project's folder or below, links followed, are always
// open; files outside need a person's agreement.
class MediaAccess {
 public:
  MediaAccess() = default;
  explicit MediaAccess(bool allows_all) : allows_all_(allows_all) {}

  void Allow(const std::string& path);
  // Error (kNoInput) if the file lies outside of the folder and nobody agreed to open it.
  std::optional<Error> WhyClosed(const std::string& path, const std::string& project_path) const;

 private:
  bool allows_all_ = false;
  std::set<std::string> allowed_;  // links followed
};

// The reference, if it is seen in rendered pictures.
std::optional<ProjectReference> RenderedReference(const Project& project);

// What is heard for `length_s` from `first_s` on [s since frame 0]; nothing if there is no sound or
// it is mute. Error if its file must not be opened.
Result<std::optional<SoundPart>> HeardIn(const Project& project, const std::string& project_path,
                                         double first_s, double length_s,
                                         const MediaAccess& access);

// Error if rendering pictures needs a file that must not be opened.
std::optional<Error> WhyClosedToPictures(const Project& project, const std::string& project_path,
                                         const MediaAccess& access);

}  // namespace hazumi::edit
