#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "engine/exchange/import/import_report.h"
#include "engine/project/compile.h"
#include "engine/project/project_writer.h"

namespace hazumi {

int RunImport(const Options& options) {
  const std::string& file = options.files[0];
  const Result<Imported> imported = Import(file, options.import);
  if (!imported.ok()) return Complain(imported.error());
  const ImportReport& report = imported.value().report;
  PrintWarnings(file, Shortened(report.warnings, options.all_warnings ? 0 : kShortReport));
  // What could not be read back is not saved.
  const Result<Compiled> compiled = CompileAnimation(imported.value().project);
  if (!compiled.ok()) return Complain(compiled.error());
  const Result<Done> saved = SaveProject(imported.value().project, options.output);
  if (!saved.ok()) return Complain(saved.error());
  for (const std::string& fact : report.facts) PrintLine(stdout, "%s", fact.c_str());
  PrintLine(stdout, "saved as %s", options.output.c_str());
  return kExitOk;
}

}  // namespace hazumi
