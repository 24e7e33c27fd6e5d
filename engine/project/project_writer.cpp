#include "engine/project/project_writer.h"

#include <filesystem>

#include "engine/project/fields/project_fields.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/text_file.h"
#include "engine/project/project_files.h"

namespace hazumi {

Json ToJson(const ProjectFigure& figure) {
  if (figure.file.empty()) return FromText(figure.embedded_json);
  return ObjectToJson(figure, [](FieldWriter& out, const ProjectFigure& reference) {
    out.Required({"file"}, reference.file);
  });
}

std::string WriteProject(const Project& project) { return FormatJson(ToJson(project)); }

// As the reader counts it.
static size_t BytesOfTree(const Json& json) {
  size_t bytes = TreeBytes(json);
  if (json.is_array()) {
    for (const Json& item : json) bytes += BytesOfTree(item);
  } else if (json.is_object()) {
    for (const auto& item : json.items()) {
      bytes += NameBytes(item.key()) + BytesOfTree(item.value());
    }
  }
  return bytes;
}

static Error TooLarge(const std::string& size, const std::string& path) {
  Error error = MakeError(Check::kTooLargeToSave, "", {size});
  error.file = path;
  return error;
}

Result<std::string> TextToSave(const Project& project, const std::string& path) {
  const Json json = ToJson(project);
  const size_t bytes = BytesOfTree(json);
  if (bytes > kMaxTreeBytes) return TooLarge(std::to_string(bytes / 1000000) + " MB", path);
  std::string text = FormatJson(json);
  if (text.size() > kLargestFile) {
    return TooLarge(std::to_string(text.size() >> 20) + " MiB", path);
  }
  return text;
}

Result<Done> SaveProject(const Project& project, const std::string& path,
                         const std::atomic<bool>* cancel) {
  const Result<std::string> text = TextToSave(project, path);
  if (!text.ok()) return text.error();
  Result<Done> written = ReplaceTextFile(path, text.value(), InputKind::kProject, cancel);
  if (written.ok()) KeepFilesOf(project, path);
  return written;
}

void RebaseReferences(Project* project, const std::string& from_folder,
                      const std::string& to_folder) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path from = fs::absolute(from_folder, failed), to = fs::absolute(to_folder, failed);
  if (failed) return;
  const auto rebase = [&](std::string* file) {
    if (file->empty() || fs::path(*file).is_absolute()) return;
    *file = (from / *file).lexically_normal().lexically_relative(to.lexically_normal()).string();
  };
  rebase(&project->figure.file);
  if (project->audio) rebase(&project->audio->file);
  if (project->reference) rebase(&project->reference->file);
}

}  // namespace hazumi
