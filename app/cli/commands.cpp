#include "app/cli/commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/cli/exit_codes.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "engine/exchange/content.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/import/import_report.h"
#include "engine/exchange/read_character.h"
#include "engine/exchange/reader/whole_file.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"

namespace hazumi {

int Complain(const Error& error) {
  PrintLine(stderr, "hazumi: %s", error.ToString().c_str());
  return ExitCodeOf(error);
}

namespace {

Error InFile(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

// --method, --step and --tolerance go before what the file and its regions say.
void ApplySolverOptions(const Options& options, Project* project) {
  ProjectSolver& solver = project->solver;
  solver.method = options.method.value_or(solver.method);
  if (options.step_s) solver.step_s = options.step_s;
  if (options.tolerance_deg) solver.tolerance_deg = options.tolerance_deg;
  for (ProjectRegion& region : project->regions) {
    if (options.method) region.method.reset();
    if (options.step_s) region.step_s.reset();
    if (options.tolerance_deg) region.tolerance_deg.reset();
  }
}

bool Uses(const Animation& animation, Method method) {
  return animation.solver.method == method ||
         std::any_of(animation.regions.begin(), animation.regions.end(),
                     [&](const DynamicsRegion& region) { return region.method == method; });
}

// Of options that only the method not used would heed.
void WarnAboutSolverOptions(const Options& options, const Animation& animation,
                            std::vector<Warning>* warnings) {
  if (options.step_s && !Uses(animation, Method::kPaper)) {
    warnings->push_back(
        {"--step", "has no effect: everything is solved by method exact; use --tolerance"});
  }
  if (options.tolerance_deg && !Uses(animation, Method::kExact)) {
    warnings->push_back(
        {"--tolerance", "has no effect: everything is solved by method paper; use --step"});
  }
}

// A project has a million frames at most, and so has what is made of it.
std::optional<Error> CheckLength(const Animation& animation, const Options& options) {
  constexpr double kMostFrames = 1e6;
  if (!options.rate) return std::nullopt;
  const double seconds = animation.rate.SecondsAt(animation.last_frame - animation.first_frame);
  const double frames = std::floor(options.rate->FrameAt(seconds)) + 1.0;
  if (frames <= kMostFrames) return std::nullopt;
  return Error{ErrorCode::kSemantics, "", "--fps",
               FormatNumber(frames) + " output frames; 1000000 are the most, choose a lower rate"};
}

// Projects are told by their suffix, all else by content: a .json may be either.
bool IsProject(const std::string& file) {
  if (file.ends_with(".kfa")) return true;
  if (!file.ends_with(".json")) return false;
  const Result<std::string> beginning = FileBeginning(file, kContentBytes);
  return beginning.ok() && !FormatOf(beginning.value(), file).ok();
}

Result<Project> LoadOrImport(const std::string& file, const ImportOptions& options,
                             ImportReport* report) {
  if (IsProject(file)) return LoadProject(file);
  Result<Imported> imported = Import(file, options);
  if (!imported.ok()) return imported.error();
  *report = std::move(imported.value().report);
  return std::move(imported.value().project);
}

}  // namespace

Error InterruptedError() { return {ErrorCode::kInterrupted, "", "", "interrupted"}; }

Result<Imported> Import(const std::string& file, const ImportOptions& options) {
  ReadOptions reading;
  reading.is_cancelled = [] { return Interrupted().load(); };
  const Result<Character> character = ReadCharacter(file, reading);
  if (!character.ok()) return character.error();
  Result<Imported> imported = ImportProject(character.value(), options);
  if (!imported.ok()) return InFile(imported.error(), file);
  return imported;
}

Result<BakedProject> BakeProject(Project project, const Options& options) {
  Result<Compiled> compiled = CompileAnimation(project, &Interrupted());
  if (Interrupted()) return InterruptedError();
  if (!compiled.ok()) return compiled.error();
  if (auto error = CheckLength(compiled.value().animation, options)) return *error;
  Result<Motion> motion =
      Bake(compiled.value().animation, {options.rate, &Interrupted(), /*energy=*/true});
  if (Interrupted()) return InterruptedError();
  if (!motion.ok()) return motion.error();
  std::vector<Warning> warnings = std::move(compiled.value().warnings);
  WarnAboutSolverOptions(options, compiled.value().animation, &warnings);
  const std::vector<Warning>& baked = motion.value().warnings;
  warnings.insert(warnings.end(), baked.begin(), baked.end());
  return BakedProject{std::move(project), std::move(compiled.value().animation),
                      std::move(motion).value(), std::move(warnings)};
}

Result<BakedProject> LoadAndBake(const std::string& file, const Options& options) {
  ImportReport report;
  Result<Project> project = LoadOrImport(file, options.import, &report);
  if (!project.ok()) return InFile(project.error(), file);
  ApplySolverOptions(options, &project.value());
  Result<BakedProject> baked = BakeProject(std::move(project).value(), options);
  if (!baked.ok()) {
    const bool is_interrupted = baked.error().code == ErrorCode::kInterrupted;
    return is_interrupted ? baked.error() : InFile(baked.error(), file);
  }
  std::vector<Warning>& warnings = baked.value().warnings;
  const std::vector<Warning> of_import =
      Shortened(report.warnings, options.all_warnings ? 0 : kShortReport);
  warnings.insert(warnings.begin(), of_import.begin(), of_import.end());
  return baked;
}

void PrintWarnings(const std::string& file, const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    PrintLine(stderr, "hazumi: %s: %s: warning: %s", file.c_str(), warning.place.c_str(),
              warning.message.c_str());
  }
}

}  // namespace hazumi
