#include "engine/project/project_writer.h"

#include <filesystem>

#include "engine/project/project_fields.h"
#include "engine/project/text_file.h"

namespace hazumi {

Json ToJson(const ProjectFigure& figure) {
  if (figure.file.empty()) return FromText(figure.embedded_json);
  return ObjectToJson(figure, [](FieldWriter& out, const ProjectFigure& reference) {
    out.Required("file", reference.file);
  });
}

std::string WriteProject(const Project& project) { return FormatJson(ToJson(project)); }

// As the reader counts them: objects and arrays among them.
static size_t CountValues(const Json& json) {
  size_t count = 1;
  if (json.is_structured()) {
    for (const Json& item : json) count += CountValues(item);
  }
  return count;
}

static Error TooLarge(const std::string& size, const std::string& path) {
  Error error = MakeError(Check::kTooLargeToSave, "", {size});
  error.file = path;
  return error;
}

Result<std::string> TextToSave(const Project& project, const std::string& path) {
  const Json json = ToJson(project);
  const size_t values = CountValues(json);
  if (values > kMaxJsonValues) return TooLarge(std::to_string(values) + " values", path);
  std::string text = FormatJson(json);
  if (text.size() > kLargestFile) {
    return TooLarge(std::to_string(text.size() >> 20) + " MiB", path);
  }
  return text;
}

Result<Done> SaveProject(const Project& project, const std::string& path) {
  const Result<std::string> text = TextToSave(project, path);
  if (!text.ok()) return text.error();
  return ReplaceTextFile(path, text.value());
}

void RebaseReferences(Project* project, const std::string& from_folder,
                      const std::string& to_folder) {
  namespace fs = std::filesystem;
  std::string& file = project->figure.file;
  if (file.empty() || fs::path(file).is_absolute()) return;
  std::error_code failed;
  const fs::path from = fs::absolute(from_folder, failed), to = fs::absolute(to_folder, failed);
  if (failed) return;
  file = (from / file).lexically_normal().lexically_relative(to.lexically_normal()).string();
}

}  // namespace hazumi
