#include "ui/edit/media_files.h"

#include <filesystem>

#include "engine/base/input_files.h"
#include "engine/project/project_files.h"
#include "engine/timeline/frame_time.h"

namespace hazumi::edit {

namespace {

std::optional<Error> In(const char* place, std::optional<Error> error) {
  if (error) error->place = place;
  return error;
}

}  // namespace

void MediaAccess::Allow(const std::string& path) {
  if (!path.empty()) allowed_.insert(FollowLinks(path));
}

std::optional<Error> MediaAccess::WhyClosed(const std::string& path,
                                            const std::string& project_path) const {
  if (path.empty() || allows_all_ || allowed_.contains(FollowLinks(path))) return std::nullopt;
  const std::filesystem::path project = FollowLinks(project_path);
  const bool has_folder = !project_path.empty();
  if (has_folder && LiesIn(path, project.parent_path().string())) return std::nullopt;
  // A missing file is reported where it is opened.
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && !unknown) return std::nullopt;
  return Error{ErrorCode::kNoInput, path, "",
               "lies outside of the project's folder and is not opened unasked; copy it there, "
               "or allow it: the command line with --open-outside, the editor when it asks"};
}

std::optional<ProjectReference> RenderedReference(const Project& project) {
  const auto& reference = project.reference;
  return reference && reference->rendered && !reference->mute ? reference : std::nullopt;
}

Result<std::optional<SoundPart>> HeardIn(const Project& project, const std::string& project_path,
                                         double first_s, double length_s,
                                         const MediaAccess& access) {
  if (!project.audio || project.audio->mute) return std::optional<SoundPart>();
  const std::string file = SoundPath(project, project_path);
  if (auto closed = In("audio.file", access.WhyClosed(file, project_path))) return *closed;
  const FrameRate rate{project.fps.num, project.fps.den};
  return std::optional(SoundPart{file, first_s - rate.SecondsAt(project.audio->start_frame),
                                 length_s, project.audio->gain_db});
}

std::optional<Error> WhyClosedToPictures(const Project& project, const std::string& project_path,
                                         const MediaAccess& access) {
  if (!RenderedReference(project)) return std::nullopt;
  return In("reference.file", access.WhyClosed(ReferencePath(project, project_path), project_path));
}

}  // namespace hazumi::edit
