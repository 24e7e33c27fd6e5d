#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "engine/exchange/import/import_project.h"
#include "engine/project/project_writer.h"
#include "ui/edit/check_saved.h"

namespace hazumi {

int RunImport(const Options& options) {
  const std::string& file = options.files[0];
  const Result<ImportOptions> how = ImportOptionsOf(options);
  if (!how.ok()) return Complain(how.error());
  const Result<Imported> imported = Import(file, how.value());
  if (!imported.ok()) return Complain(imported.error());
  const ImportReport& report = imported.value().report;
  PrintWarnings(file, Shortened(report.warnings, options.all_warnings ? 0 : kShortReport));
  // What --check would refuse is not saved.
  const Project& project = imported.value().project;
  const Result<Done> checked = edit::CheckSaved(project, file, &Interrupted());
  if (Interrupted()) return Complain(InterruptedError());
  if (!checked.ok()) return Complain(InFile(checked.error(), file));
  const Result<Done> saved = SaveProject(project, options.output, &Interrupted());
  if (!saved.ok()) return Complain(saved.error());
  for (const std::string& fact : report.facts) PrintLine(stdout, "%s", fact.c_str());
  PrintLine(stdout, "saved as %s", options.output.c_str());
  return kExitOk;
}

}  // namespace hazumi
