#include "engine/project/project_files.h"

#include <filesystem>

#include "engine/base/input_files.h"

namespace hazumi {

namespace {

std::string Beside(const std::string& project_path, const std::string& file) {
  if (file.empty()) return "";
  return (std::filesystem::path(project_path).parent_path() / file).lexically_normal().string();
}

}  // namespace

std::string FigurePath(const Project& project, const std::string& project_path) {
  return Beside(project_path, project.figure.file);
}

std::string SoundPath(const Project& project, const std::string& project_path) {
  return project.audio ? Beside(project_path, project.audio->file) : "";
}

std::string ReferencePath(const Project& project, const std::string& project_path) {
  return project.reference ? Beside(project_path, project.reference->file) : "";
}

void KeepFilesOf(const Project& project, const std::string& project_path) {
  KeepInput(project_path, InputKind::kProject);
  KeepInput(FigurePath(project, project_path), InputKind::kFigure);
  KeepInput(SoundPath(project, project_path), InputKind::kSound);
  KeepInput(ReferencePath(project, project_path), InputKind::kReference);
}

std::string ShownName(const std::string& name, const std::string& file) {
  const bool is_named = !name.empty() && name != "Untitled";
  return is_named || file.empty() ? name : std::filesystem::path(file).stem().string();
}

}  // namespace hazumi
