#include "ui/edit/media_files.h"

#include <filesystem>

#include "engine/timeline/frame_time.h"

namespace hazumi::edit {

namespace {

std::string Beside(const std::string& project_path, const std::string& file) {
  return (std::filesystem::path(project_path).parent_path() / file).string();
}

}  // namespace

std::string SoundPath(const Project& project, const std::string& project_path) {
  return project.audio ? Beside(project_path, project.audio->file) : "";
}

std::string ReferencePath(const Project& project, const std::string& project_path) {
  return project.reference ? Beside(project_path, project.reference->file) : "";
}

std::optional<ProjectReference> RenderedReference(const Project& project) {
  const auto& reference = project.reference;
  return reference && reference->rendered && !reference->mute ? reference : std::nullopt;
}

std::optional<SoundPart> HeardIn(const Project& project, const std::string& project_path,
                                 double first_s, double length_s) {
  if (!project.audio || project.audio->mute) return std::nullopt;
  const FrameRate rate{project.fps.num, project.fps.den};
  return SoundPart{SoundPath(project, project_path),
                   first_s - rate.SecondsAt(project.audio->start_frame), length_s,
                   project.audio->gain_db};
}

}  // namespace hazumi::edit
