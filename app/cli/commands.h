#pragma once

#include "app/cli/options.h"
#include "engine/analysis/effort.h"
#include "engine/bake/motion.h"
#include "engine/project/project.h"

namespace hazumi {

// Each does one task of the command line and returns the exit code.
int RunRender(const Options& options);
int RunExport(const Options& options);
int RunBake(const Options& options);
int RunCheck(const Options& options);
int RunInfo(const Options& options);
int RunImport(const Options& options);
int RunFlight(const Options& options);
int RunWindow(const Options& options);
int RunEdits(const Options& options);
int RunOperators();
int RunSchema();
int RunSweep(const Options& options);
int RunVerify(const Options& options);
int RunFields(const Options& options);
int RunQuantities();
int RunManual();
int RunCompletion(const Options& options);

// Prints "hazumi: file: place: message" to standard error and returns the exit code.
int Complain(const Error& error);
// With the file's name, unless the error has one.
Error InFile(Error error, const std::string& file);

// A project, read, resolved and baked with the command line's changes.
struct BakedProject {
  Project project;
  Animation animation;
  Motion motion;
  std::vector<Warning> warnings;  // of importing, compiling and baking
};
// A project, or a file of another program as one. Errors: also kInterrupted.
Result<BakedProject> LoadAndBake(const std::string& file, const Options& options);
// A file of another program as a project. Errors: also kInterrupted.
Result<Imported> Import(const std::string& file, const ImportOptions& options);
// How files of other programs are read, with the roles of the map that is named. Errors: of reading
// the map.
Result<ImportOptions> ImportOptionsOf(const Options& options);
// Problems of the motion besides those that are warnings; none of a motion without frames.
std::vector<std::string> ProblemTexts(const BakedProject& baked, const Effort& effort);
// Prints the warnings to standard error.
void PrintWarnings(const std::string& file, const std::vector<Warning>& warnings);
// Prints from which frame the motion of a region is one of several likely motions.
void PrintNotes(const std::string& file, const Motion& motion);
// For a bake that the user broke off.
Error InterruptedError();

}  // namespace hazumi
