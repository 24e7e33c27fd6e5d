#include <cstdio>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "engine/exchange/import/import_report.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"

namespace hazumi {

namespace {

// What --check would say of the file to be written: what it refuses is not saved.
std::optional<Error> Refusal(const Project& project, const Options& options) {
  const Result<std::string> text = TextToSave(project, options.output);
  if (!text.ok()) return text.error();
  Result<Project> read = ParseProject(text.value(), options.files[0]);
  if (!read.ok()) return read.error();
  const Result<BakedProject> baked = BakeProject(std::move(read).value(), {});
  if (baked.ok()) return std::nullopt;
  Error error = baked.error();
  if (error.code != ErrorCode::kInterrupted) error.file = options.files[0];
  return error;
}

}  // namespace

int RunImport(const Options& options) {
  const std::string& file = options.files[0];
  const Result<Imported> imported = Import(file, options.import);
  if (!imported.ok()) return Complain(imported.error());
  const ImportReport& report = imported.value().report;
  PrintWarnings(file, Shortened(report.warnings, options.all_warnings ? 0 : kShortReport));
  if (const auto error = Refusal(imported.value().project, options)) return Complain(*error);
  const Result<Done> saved = SaveProject(imported.value().project, options.output);
  if (!saved.ok()) return Complain(saved.error());
  for (const std::string& fact : report.facts) PrintLine(stdout, "%s", fact.c_str());
  PrintLine(stdout, "saved as %s", options.output.c_str());
  return kExitOk;
}

}  // namespace hazumi
