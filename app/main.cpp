#include <cstdio>
#include <exception>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/terminal.h"

namespace {

int Run(const hazumi::Options& options) {
  switch (options.task) {
    case hazumi::Task::kRender:
      return hazumi::RunRender(options);
    case hazumi::Task::kExport:
      return hazumi::RunExport(options);
    case hazumi::Task::kBake:
      return hazumi::RunBake(options);
    case hazumi::Task::kCheck:
      return hazumi::RunCheck(options);
    case hazumi::Task::kInfo:
      return hazumi::RunInfo(options);
    case hazumi::Task::kFlight:
      return hazumi::RunFlight(options);
    case hazumi::Task::kImport:
      return hazumi::RunImport(options);
    case hazumi::Task::kRun:
      return hazumi::RunEdits(options);
    case hazumi::Task::kOperators:
      return hazumi::RunOperators();
    case hazumi::Task::kSchema:
      return hazumi::RunSchema();
    case hazumi::Task::kSweep:
      return hazumi::RunSweep(options);
    case hazumi::Task::kVerify:
      return hazumi::RunVerify(options);
    case hazumi::Task::kFields:
      return hazumi::RunFields(options);
    case hazumi::Task::kQuantities:
      return hazumi::RunQuantities();
    case hazumi::Task::kManual:
      return hazumi::RunManual();
    case hazumi::Task::kCompletion:
      return hazumi::RunCompletion(options);
    case hazumi::Task::kWindow:
      return hazumi::RunWindow(options);
  }
  return hazumi::kExitUsage;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    hazumi::KeepStandardStreams();
    hazumi::CatchInterrupts();
    const hazumi::ParsedCommandLine parsed = hazumi::ParseCommandLine(argc, argv);
    return hazumi::FinishOutput(parsed.options ? Run(*parsed.options) : parsed.exit_code);
  } catch (const std::exception& error) {
    hazumi::PrintLine(stderr, "hazumi: failed: %s", error.what());
    return hazumi::kExitFailed;
  }
}
