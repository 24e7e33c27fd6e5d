#include "app/cli/commands.h"

#include <cstdio>

#include "app/cli/exit_codes.h"
#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"

namespace hazumi {

int Complain(const Error& error) {
  std::fprintf(stderr, "hazumi: %s\n", error.ToString().c_str());
  return ExitCodeOf(error);
}

namespace {

Error InFile(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

// --method and --step go before what the file and its regions say.
void ApplySolverOptions(const Options& options, Project* project) {
  if (options.method) {
    project->solver.method = *options.method;
    for (ProjectRegion& region : project->regions) region.method.reset();
  }
  if (options.step_s) {
    project->solver.step_s = *options.step_s;
    for (ProjectRegion& region : project->regions) region.step_s.reset();
  }
}

}  // namespace

Result<BakedProject> LoadAndBake(const std::string& file, const Options& options) {
  Result<Project> project = LoadProject(file);
  if (!project.ok()) return InFile(project.error(), file);
  ApplySolverOptions(options, &project.value());
  Result<Compiled> compiled = CompileAnimation(project.value());
  if (!compiled.ok()) return InFile(compiled.error(), file);
  Result<Motion> motion = Bake(compiled.value().animation, {options.rate});
  if (!motion.ok()) return InFile(motion.error(), file);
  std::vector<Warning> warnings = compiled.value().warnings;
  const std::vector<Warning>& baked = motion.value().warnings;
  warnings.insert(warnings.end(), baked.begin(), baked.end());
  return BakedProject{std::move(project).value(), std::move(compiled.value().animation),
                      std::move(motion).value(), std::move(warnings)};
}

void PrintWarnings(const std::string& file, const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    std::fprintf(stderr, "hazumi: %s: %s: warning: %s\n", file.c_str(), warning.place.c_str(),
                 warning.message.c_str());
  }
}

std::string EventTable(const Motion& motion) {
  std::string text;
  for (const MotionEvent& event : motion.events) {
    char line[160];
    std::snprintf(line, sizeof line, "%-10s  frame %4d  %10.6f s  %s\n", NameOf(event.kind),
                  event.frame, event.time, event.joint.c_str());
    text += line;
  }
  return text;
}

}  // namespace hazumi
