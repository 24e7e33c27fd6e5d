#include "engine/project/project_reader.h"

#include <filesystem>

#include "engine/figure/figure_builder.h"
#include "engine/project/checks/document_checks.h"
#include "engine/project/checks/field_checks.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/figure_fields.h"
#include "engine/project/figure_file.h"
#include "engine/project/json/read_value.h"
#include "engine/project/json/text_file.h"
#include "engine/project/project_files.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

// A file that cannot be read is an error of the project, which names the wrong file.
Error InProject(Error error, const std::string& reference) {
  if (error.code != ErrorCode::kNoInput) return error;
  std::error_code failed;
  const fs::path full = fs::absolute(error.file, failed);
  return MakeError(Check::kFigureUnreadable, "figure.file",
                   {Quoted(reference), error.message, failed ? error.file : full.string()});
}

void ReadFigureFile(const std::string& project_file, Project* project, const Site& site) {
  std::vector<Warning> warnings, unknown;
  Result<FigureSpec> spec = LoadFigure(FigurePath(*project, project_file), &warnings, &unknown);
  ProjectFigure& figure = project->figure;
  if (!spec.ok()) return site.errors->Report(InProject(spec.error(), figure.file));
  figure.spec = std::move(spec).value();
  const auto tell = [](const std::vector<Warning>& list, std::vector<Warning>* all) {
    for (const Warning& warning : list) {
      const std::string place = warning.place.empty() ? "figure" : "figure." + warning.place;
      all->push_back({place, warning.message});
    }
  };
  tell(warnings, site.warnings);
  tell(unknown, site.unknown);
}

void CheckProject(const Project& project, FirstError* errors) {
  CheckDocument(project, errors);
  if (!errors->ok()) return;
  const Result<Figure> figure = BuildFigure(project.figure.spec);  // it was tried when read
  CheckNames(project, figure.value(), errors);
}

Project ReadProject(const Json& json, const std::string& file_name, FirstError* errors) {
  Project project;
  const Site site{"", errors, &project.read.warnings, &project.read.unknown};
  if (!ExpectFormat(json, kProjectFormat, kNewestFormat, Check::kNotAProject, site)) return project;
  ReadValue(json, site, project);
  if (errors->ok() && !project.figure.file.empty()) {
    ReadFigureFile(file_name, &project, site);
  }
  if (errors->ok()) CheckProject(project, errors);
  return project;
}

}  // namespace

void ReadValue(const Json& json, const Site& site, ProjectFigure& figure) {
  if (json.is_object() && json.contains("format")) {
    figure.spec = ReadFigure(json, site);
    figure.embedded_json = CompactJson(json);
    return;
  }
  ReadObject(json, site, figure, [](FieldReader& in, ProjectFigure& reference) {
    in.Required({"file"}, reference.file);
    CheckNotEmpty(reference.file, in.At("file"));
  });
}

Result<Project> LoadProject(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  Result<Project> project = ParseProject(text.value(), path);
  if (project.ok()) KeepFilesOf(project.value(), path);
  return project;
}

Result<Project> ParseProject(std::string_view text, const std::string& file_name) {
  FirstError errors;
  const std::optional<Json> json = ParseJson(text, &errors);
  if (!json) return errors.In(file_name);
  Project project = ReadProject(*json, file_name, &errors);
  if (!errors.ok()) return errors.In(file_name);
  return project;
}

}  // namespace hazumi
